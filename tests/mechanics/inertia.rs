//! Inertia tensors, compared with sums over mass points at all scales; and the tensors that are
//! rejected.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use newton_euler::gyroscopic;
use newton_euler::inertia::{InertiaTensor, InvalidInertia};
use proptest::prelude::*;

use crate::reference::{attitude, body, number, numbers, statement, vector};

type Points = Vec<(f64, Vector3<f64>)>;

/// Σ m ((r·r) 1 - r rᵀ) about a point, straight from the definition.
fn point_tensor(points: &Points, about: &Vector3<f64>) -> Matrix3<f64> {
    let term = |(m, at): &(f64, Vector3<f64>)| {
        let r = at - about;
        (Matrix3::identity() * r.dot(&r) - r * r.transpose()) * *m
    };
    points.iter().map(term).sum()
}

fn some_vector() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0).prop_map(Vector3::from)
}

fn some_attitude() -> impl Strategy<Value = UnitQuaternion<f64>> {
    prop::array::uniform4(-1.0..1.0)
        .prop_map(|[w, x, y, z]| Quaternion::new(w, x, y, z))
        .prop_filter("of some length", |q| q.norm() > 0.1)
        .prop_map(UnitQuaternion::new_normalize)
}

fn some_points() -> impl Strategy<Value = Points> {
    prop::collection::vec((0.1..2.0, some_vector()), 1..12)
}

/// Entries of up to twelve points of mass two at distance two: 96, summed in some fifty roundings.
const SUMMED: f64 = 1e-12;

fn close(computed: &Matrix3<f64>, expected: &Matrix3<f64>, tolerance: f64) {
    let error = (computed - expected).amax();
    assert!(
        error <= tolerance,
        "{computed} is not {expected}: off by {error:e}"
    );
}

proptest! {
    #[test]
    fn mass_points(points in some_points()) {
        let found = InertiaTensor::from_points(points.iter().copied()).unwrap();
        let mass: f64 = points.iter().map(|(m, _)| m).sum();
        let moment: Vector3<f64> = points.iter().map(|(m, r)| r * *m).sum();
        prop_assert!((found.mass - mass).abs() < 1e-14);
        prop_assert!((found.center - moment / mass).amax() < 1e-14);
        close(&found.inertia.matrix(), &point_tensor(&points, &found.center), SUMMED);
        // Products are positive where the sum of m x y is, entries of the tensor where it is negative.
        let xy: f64 = points.iter().map(|(m, r)| {
            let r = r - found.center;
            m * r.x * r.y
        }).sum();
        prop_assert!((found.inertia.positive_products()[0] - xy).abs() < SUMMED);
        prop_assert!((found.inertia.off_diagonals()[0] + xy).abs() < SUMMED);
    }

    #[test]
    fn parallel_axis(points in some_points(), offset in some_vector()) {
        let found = InertiaTensor::from_points(points.iter().copied()).unwrap();
        let shifted = found.inertia.shifted_from_center(found.mass, &offset).unwrap();
        close(&shifted.matrix(), &point_tensor(&points, &(found.center + offset)), SUMMED);
        if let Ok(back) = shifted.shifted_to_center(found.mass, &-offset) {
            close(&back.matrix(), &found.inertia.matrix(), SUMMED);
        } else {
            // Only where rounding of what was subtracted breaks a condition that held barely.
            let moments = found.inertia.principal_axes().moments;
            prop_assert!(moments.x + moments.y - moments.z < SUMMED);
        }
    }

    #[test]
    fn rotation(points in some_points(), turn in some_attitude()) {
        let about = Vector3::zeros();
        let j = InertiaTensor::from_matrix(&point_tensor(&points, &about)).unwrap();
        let turned = points.iter().map(|(m, r)| (*m, turn * r)).collect();
        close(&j.rotated(&turn).matrix(), &point_tensor(&turned, &about), SUMMED);
        // What comes out passes the checks again.
        prop_assert!(InertiaTensor::from_matrix(&j.rotated(&turn).matrix()).is_ok());
    }

    #[test]
    fn inertial_moment(points in some_points(), w in some_vector(), dw in some_vector()) {
        let j = InertiaTensor::from_matrix(&point_tensor(&points, &Vector3::zeros())).unwrap();
        let expected: Vector3<f64> = points
            .iter()
            .map(|(m, r)| -r.cross(&(dw.cross(r) + w.cross(&w.cross(r)))) * *m)
            .sum();
        prop_assert!((gyroscopic::inertial_moment(&j, &w, &dw) - expected).amax() < SUMMED);
        let momentum: Vector3<f64> = points.iter().map(|(m, r)| r.cross(&w.cross(r)) * *m).sum();
        prop_assert!((j.times(&w) - momentum).amax() < SUMMED);
    }

    #[test]
    fn principal_axes_of_any_body(
        a in 0.0..1.0,
        b in 0.1..1.0,
        lift in prop_oneof![Just(0.0), Just(1e-13), Just(1e-9), Just(1e-4), 0.0..1.0],
        repeated in any::<bool>(),
        turn in some_attitude(),
    ) {
        // From plane bodies (lift 0) to any; with nearly repeated moments on demand.
        let a = if repeated { b * (1.0 - 1e-3 * lift) } else { a };
        let j = InertiaTensor::principal(a + lift, b + lift, a + b).unwrap().rotated(&turn);
        let principal = j.principal_axes();
        let axes = principal.axes.to_rotation_matrix().into_inner();
        let [x, y, z] = principal.moments.into();
        prop_assert!(x <= y && y <= z);
        let rebuilt = axes * Matrix3::from_diagonal(&principal.moments) * axes.transpose();
        // A dozen plane rotations, each a few roundings of the largest moment.
        close(&rebuilt, &j.matrix(), 16.0 * f64::EPSILON * z);
        close(&(axes * axes.transpose()), &Matrix3::identity(), 2e-15); // four times two in the last place of |q|
        prop_assert!((axes.determinant() - 1.0).abs() < 2e-15);
        let mut given = [a + lift, b + lift, a + b];
        given.sort_by(f64::total_cmp);
        for (found, given) in [x, y, z].into_iter().zip(given) {
            prop_assert!((found - given).abs() < 16.0 * f64::EPSILON * z);
        }
    }

    #[test]
    fn inverse_at_any_scale(points in prop::collection::vec((0.5..2.0, some_vector()), 5..9), decade in -120..121) {
        let j = point_tensor(&points, &Vector3::zeros());
        let cube = Matrix3::identity() * j.trace(); // keeps the condition number below 3
        let scale = 10f64.powi(decade);
        let j = InertiaTensor::from_matrix(&((j + cube) * scale)).unwrap();
        let error = j.inverse().unwrap() * j.matrix() - Matrix3::identity();
        prop_assert!(error.amax() < 2e-15); // H10: nine products, condition 3
    }
}

#[test]
fn accepted() {
    let principal = InertiaTensor::principal;
    for [a, b, c] in [
        [1.0, 2.0, 3.0],
        [0.1, 0.2, 0.1 + 0.2],
        [0.1, 0.2, 0.3],
        [0.0, 1.0, 1.0],
        [0.0, 0.0, 0.0],
        [1.0, 1.0, 2.0 * (1.0 + f64::EPSILON)],
    ] {
        for scale in [1.0, 1e-120, 1e120, 1e-9, 1e12] {
            for [x, y, z] in [[a, b, c], [b, c, a], [c, a, b]] {
                let j = principal(x * scale, y * scale, z * scale).unwrap();
                assert_eq!(j.moments(), [x * scale, y * scale, z * scale]);
            }
        }
    }
    // A square plate in axes along its diagonals' bisector, and a rod along (1, 1, 1): equality in every frame.
    assert!(InertiaTensor::products(2.0, 2.0, 4.0, 2.0, 0.0, 0.0).is_ok());
    assert!(InertiaTensor::products(2.0, 2.0, 2.0, 1.0, 1.0, 1.0).is_ok());
}

#[test]
fn refused() {
    use InvalidInertia::*;
    for scale in [1.0, 2f64.powi(-400), 2f64.powi(400)] {
        let tensor = |entries: [f64; 6]| {
            let [xx, yy, zz, xy, yz, zx] = entries.map(|entry| entry * scale);
            InertiaTensor::tensor(xx, yy, zz, xy, yz, zx).unwrap_err()
        };
        let triangle = |axis| Triangle {
            axis,
            moment: 2.5 * scale,
            others: 2.0 * scale,
        };
        assert_eq!(tensor([1.0, 1.0, 2.5, 0.0, 0.0, 0.0]), triangle("z"));
        assert_eq!(tensor([1.0, 2.5, 1.0, 0.0, 0.0, 0.0]), triangle("y"));
        assert_eq!(tensor([2.5, 1.0, 1.0, 0.0, 0.0, 0.0]), triangle("x"));
        assert_eq!(
            tensor([1.0, -1.0, 1.0, 0.0, 0.0, 0.0]),
            Negative {
                axis: "y",
                moment: -scale
            }
        );
        for (entry, entries) in [
            ("xy", [1.0, 1.0, 1.0, 0.6, 0.0, 0.0]),
            ("yz", [1.0, 1.0, 1.0, 0.0, -0.6, 0.0]),
            ("zx", [1.0, 1.0, 1.0, 0.0, 0.0, 0.6]),
        ] {
            assert_eq!(
                tensor(entries),
                Product {
                    entry,
                    product: 0.6 * scale,
                    bound: 0.5 * scale
                }
            );
        }
        // Every inequality above holds, yet about (1, 1, 1) there is too much: moments .2, 1.4, 1.4 are fine,
        // 1.8, .6, .6 are not.
        assert!(matches!(
            tensor([1.0, 1.0, 1.0, 0.4, 0.4, 0.4]),
            Principal { .. }
        ));
        let [xx, xy] = [scale, -0.4 * scale];
        assert!(InertiaTensor::tensor(xx, xx, xx, xy, xy, xy).is_ok());
    }
    let finite = InertiaTensor::principal(1.0, f64::NAN, 1.0);
    assert_eq!(finite, Err(NotFinite { entry: "yy" }));
    let finite = InertiaTensor::products(1.0, 1.0, 1.0, 0.0, f64::INFINITY, 0.0);
    assert_eq!(finite, Err(NotFinite { entry: "yz" }));
    // Ten units in the last place are more than rounding.
    assert!(InertiaTensor::principal(1.0, 1.0, 2.0 * (1.0 + 10.0 * f64::EPSILON)).is_err());

    let skew = Matrix3::new(1.0, 0.1, 0.0, 0.2, 1.0, 0.0, 0.0, 0.0, 1.0);
    let error = InertiaTensor::from_matrix(&skew).unwrap_err();
    assert_eq!(
        error,
        Asymmetric {
            entry: "xy",
            values: [0.1, 0.2]
        }
    );
    assert_eq!(
        error.to_string(),
        "not symmetric: entry xy is 0.1 above the diagonal and 0.2 below"
    );

    assert_eq!(InertiaTensor::from_points([]), Err(Mass { value: 0.0 }));
    assert_eq!(
        InertiaTensor::from_points([(-1.0, Vector3::x())]),
        Err(Mass { value: -1.0 })
    );
    let lost = [(1.0, Vector3::x()), (1.0, Vector3::x() * f64::NAN)];
    assert!(matches!(
        InertiaTensor::from_points(lost),
        Err(NotFinite { .. })
    ));
    let ball = InertiaTensor::principal(1.0, 1.0, 1.0).unwrap();
    assert!(matches!(
        ball.shifted_from_center(f64::NAN, &Vector3::x()),
        Err(Mass { .. })
    ));
    assert!(matches!(
        ball.shifted_from_center(1.0, &(Vector3::x() / 0.0)),
        Err(NotFinite { .. })
    ));
    assert!(matches!(
        ball.shifted_to_center(0.6, &Vector3::x()),
        Err(Triangle { axis: "x", .. })
    ));
}

#[test]
fn rods_and_points_have_no_inverse() {
    let [rod, point] = [0.7, 0.0].map(|j| InertiaTensor::principal(0.0, j, j).unwrap());
    assert_eq!(point.inverse(), Err(InvalidInertia::Singular));
    for k in 0..100 {
        let turn = UnitQuaternion::from_euler_angles(f64::from(k), 0.3 * f64::from(k), 0.7);
        assert_eq!(rod.rotated(&turn).inverse(), Err(InvalidInertia::Singular));
    }
    let thin = InertiaTensor::principal(1e-14, 1.0, 1.0).unwrap();
    assert_eq!(
        thin.inverse().unwrap().diagonal(),
        Vector3::new(1e14, 1.0, 1.0)
    );
}

/// Scaling by a power of two changes no digit of anything.
#[test]
fn scales_are_exact() {
    let entries = [1.3, 1.7, 2.1, -0.12, -0.05, 0.07];
    let at = |exponent: i32| {
        let [xx, yy, zz, xy, yz, zx] = entries.map(|entry| entry * 2f64.powi(exponent));
        InertiaTensor::tensor(xx, yy, zz, xy, yz, zx).unwrap()
    };
    for exponent in [-400, 400] {
        let scale = 2f64.powi(exponent);
        assert_eq!(
            at(exponent).inverse().unwrap() * scale,
            at(0).inverse().unwrap()
        );
        let [found, unit] = [at(exponent), at(0)].map(|j| j.principal_axes());
        assert_eq!(found.moments / scale, unit.moments);
        assert_eq!(found.axes, unit.axes);
    }
}

#[test]
fn ordered_principal_axes_stay_those_of_the_user() {
    let j = InertiaTensor::principal(1.0, 2.0, 2.0)
        .unwrap()
        .principal_axes();
    assert_eq!(
        (j.moments, j.axes),
        (Vector3::new(1.0, 2.0, 2.0), UnitQuaternion::identity())
    );
    let j = InertiaTensor::principal(3.0, 1.0, 2.5)
        .unwrap()
        .principal_axes();
    assert_eq!(j.moments, Vector3::new(1.0, 2.5, 3.0));
    // Each new axis is one of the old, up to sign.
    let rotation = j.axes.to_rotation_matrix().into_inner().abs();
    close(
        &rotation,
        &Matrix3::new(0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0),
        1e-15,
    );
}

/// H3b: points with coordinates that are exact far from the origin as well as near it.
#[test]
fn small_cloud_far_away() {
    let near: Points = (0..40)
        .map(|k| {
            let grid = |step: i32| f64::from((k * step) % 97 - 48) * 2f64.powi(-13); // within 6 mm
            (
                1.0 + f64::from(k % 3),
                Vector3::new(grid(31), grid(57), grid(83)),
            )
        })
        .collect();
    let origin = Vector3::new(1e9, -1e9, 1e9);
    let [here, there] = [Vector3::zeros(), origin].map(|origin| {
        InertiaTensor::from_points(near.iter().map(|(m, r)| (*m, r + origin))).unwrap()
    });
    assert_eq!(there.mass, here.mass);
    let scale = here.inertia.matrix().amax();
    close(
        &there.inertia.matrix(),
        &here.inertia.matrix(),
        1e-13 * scale,
    );
    close(
        &here.inertia.matrix(),
        &point_tensor(&near, &here.center),
        1e-14 * scale,
    );
    assert!((there.center - origin - here.center).amax() < 2e-7); // one unit in the last place at 1e9
}

/// H7: of a nearly spherical body the gyroscopic moment keeps its digits.
#[test]
fn nearly_spherical() {
    let w = Vector3::new(0.3, -1.1, 0.7);
    for epsilon in [1e-2, 1e-6, 1e-10, 1e-13] {
        let entry = |value: f64| 1.0 + epsilon * value;
        let off = |value: f64| epsilon * value;
        let (xx, yy, zz) = (entry(0.3), entry(-0.4), entry(0.9));
        let (xy, yz, zx) = (off(0.2), off(-0.5), off(0.1));
        let j = InertiaTensor::tensor(xx, yy, zz, xy, yz, zx).unwrap();
        // Of the doubles given, the deviation from 1 is exact.
        let deviation = j.matrix() - Matrix3::identity();
        let expected = w.cross(&(deviation * w));
        let error = (gyroscopic::torque(&j, &w) - expected).norm() / expected.norm();
        assert!(error < 1e-14, "{epsilon:e}: {error:e}");
    }
    // Spherical in all axes, exactly.
    let ball = InertiaTensor::principal(0.4, 0.4, 0.4).unwrap();
    let turn = UnitQuaternion::from_euler_angles(0.3, 0.4, 0.5);
    assert_eq!(ball.rotated(&turn), ball);
    assert_eq!(gyroscopic::torque(&ball, &w), Vector3::zeros());
}

/// F01, F03: planar points give mass, G, `J_G` and, moving, the inertial force and moment.
#[test]
fn planar_points() {
    let expected = statement("F01-03 planar inertia wrench");
    let points: Points = expected["points (m,x,y)"]
        .as_array()
        .unwrap()
        .iter()
        .map(|point| {
            let [m, x, y] = numbers(point);
            (m, Vector3::new(x, y, 0.0))
        })
        .collect();
    let found = InertiaTensor::from_points(points).unwrap();
    let [g_x, g_y] = numbers(&expected["G body"]);
    assert!((found.mass - number(&expected["m"])).abs() < 2e-15);
    assert!((found.center - Vector3::new(g_x, g_y, 0.0)).amax() < 1e-16);
    let [xx, yy, zz] = found.inertia.moments();
    assert!((zz - number(&expected["JG"])).abs() < 1e-15);
    assert!((xx + yy - zz).abs() < 4e-16); // a plane body
    let [w, dw] = ["omega", "alpha"].map(|name| Vector3::z() * number(&expected[name]));
    let moment = gyroscopic::inertial_moment(&found.inertia, &w, &dw);
    assert!((moment.z - number(&expected["M_iG by summation"])).abs() < 2e-15);
}

/// F06: turning in the plane, a body with products needs moments out of it.
#[test]
fn planar_motion_of_a_body_in_space() {
    let expected = statement("F06 rotation about z with products: M_i");
    let [zx, yz, zz, rate, acceleration] =
        ["Jxz", "Jyz", "Jzz", "wz", "alphaz"].map(|name| number(&expected[name]));
    let j = InertiaTensor::products(0.15, 0.16, zz, 0.0, yz, zx).unwrap();
    let [w, dw] = [rate, acceleration].map(|value| Vector3::z() * value);
    let moment = gyroscopic::inertial_moment(&j, &w, &dw);
    let names = [
        "M_ix = Jxz a - Jyz w^2",
        "M_iy = Jyz a + Jxz w^2",
        "M_iz=-Jzz a",
    ];
    let expected = Vector3::from(names.map(|name| number(&expected[name])));
    assert!((moment - expected).amax() < 1e-14); // sums of numbers up to 21
}

/// F10: the six scalar equations, here the three of rotation.
#[test]
fn six_scalar_equations() {
    let expected = statement("F10 six scalar equations");
    let rows = &expected["J tensor"];
    let j = Matrix3::from_rows(&[0, 1, 2].map(|row| vector(&rows[row]).transpose()));
    let j = InertiaTensor::from_matrix(&j).unwrap();
    let [w, force, at, couple] =
        ["w body", "body force", "at r body", "world couple"].map(|name| vector(&expected[name]));
    let q = UnitQuaternion::new_normalize(attitude(&expected["q"]).into_inner());
    let moment = at.cross(&force) + q.inverse() * couple;
    let dw = j.inverse().unwrap() * (moment - gyroscopic::torque(&j, &w));
    // Some forty roundings of numbers up to 3.
    assert!((dw - vector(&expected["alpha body"])).amax() < 5e-15);
    let inertial = gyroscopic::inertial_moment(&j, &w, &dw);
    assert!((inertial - vector(&expected["M_i full"])).amax() < 5e-15);
    assert!((q * j.times(&w) - vector(&expected["L world"])).amax() < 5e-15);
    assert!((0.5 * w.dot(&j.times(&w)) - number(&expected["T_rot"])).abs() < 5e-15);
}

/// M6: a rotor of five mass points, about its bearings' axis.
#[test]
fn rotor_of_mass_points() {
    let rotor = body("M6");
    let points: Points = rotor["given"]["points"]
        .as_array()
        .unwrap()
        .iter()
        .map(|point| {
            let [m, x, y, z] = numbers(point);
            (m, Vector3::new(x, y, z))
        })
        .collect();
    let expected = &rotor["expect"];
    let found = InertiaTensor::from_points(points).unwrap();
    assert!((found.mass - number(&expected["m"])).abs() < 1e-14);
    assert!((found.center - vector(&expected["G"])).amax() < 1e-16);
    let about_axis = found
        .inertia
        .shifted_from_center(found.mass, &-found.center)
        .unwrap();
    assert!((about_axis.moments()[2] - number(&expected["Jzz(axis)"])).abs() < 1e-16);
    let [_, yz, zx] = about_axis.positive_products();
    let [s_zx, s_yz] = numbers(&expected["Jxz,Jyz (about S)"]);
    assert!((zx - s_zx).abs() < 1e-16 && (yz - s_yz).abs() < 1e-16);
    let w = Vector3::z() * number(&rotor["given"]["omega"]);
    let dw = Vector3::z() * number(&expected["alpha"]);
    let moment = gyroscopic::inertial_moment(&about_axis, &w, &dw);
    let [x, y] = numbers(&expected["M_ix,M_iy of (1.9)"]);
    // ω² times a rounding of the products: 157² · 1e-17
    assert!((moment.x - x).abs() < 1e-12 && (moment.y - y).abs() < 1e-12);
}
