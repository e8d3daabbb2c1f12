//! Equations that are regular although any of their coefficients may vanish: directions that
//! parameters or inputs give, and attitudes that make one axis perpendicular to another. The oracle
//! is nalgebra's inverse.

use nalgebra::{Matrix2, Matrix3, UnitQuaternion, Vector2, Vector3};
use newton_euler::prelude::*;

// three drives along directions that are parameters
rigid_body!(Thrusters {
    motion: translation,
    params: [a = world(_, _, _), b = world(_, _, _), c = world(_, _, _)],
    mass: 2[kg],
    forces: [first = _ * a, second = _ * b, third = _ * c],
    outputs: [inverse],
});

/// Every matrix of 0, 1 and -2 that has an inverse.
#[test]
fn drives_along_directions_of_parameters() {
    let acceleration = Vector3::new(1.0, 2.0, 3.0);
    let mut count = 0;
    for code in 0..3_usize.pow(9) {
        let mut digits = code;
        let entries = [(); 9].map(|()| {
            let entry = [0.0, 1.0, -2.0][digits % 3];
            digits /= 3;
            entry
        });
        let directions = Matrix3::from_column_slice(&entries);
        let Some(inverse) = directions.try_inverse() else {
            continue;
        };
        let [a, b, c] = [0, 1, 2].map(|column| directions.column(column).into_owned());
        let body = Thrusters::new(ThrustersParams { a, b, c }).unwrap();
        let drives = body.inverse(0.0, &Translation::default(), &acceleration, &());
        let sizes = inverse * acceleration * 2.0;
        for (drive, (direction, size)) in [drives.first, drives.second, drives.third]
            .into_iter()
            .zip([a, b, c].into_iter().zip(sizes.iter()))
        {
            assert!((drive - direction * *size).norm() < 1e-12, "{directions}");
        }
        count += 1;
    }
    assert!(count > 10_000);
}

// a wedge whose faces an input turns
rigid_body!(Wedged {
    motion: planar_translation,
    inputs: [turn],
    mass: 2[kg],
    fields: [weight = mass * world(1, -9.8[m / s ^ 2])],
    constraints: [
        across = position.in_world().x,
        up = position.in_world().y - 1[m / s ^ 2] * t.powi(2)
    ],
    reactions: [
        one = _ * world(turn.cos(), turn.sin()),
        other = _ * world(-turn.sin(), turn.cos())
    ],
    outputs: [reactions],
});

#[test]
fn reactions_along_directions_of_an_input() {
    let body = Wedged::default();
    for eighth in 0..16 {
        let turn = f64::from(eighth) * core::f64::consts::FRAC_PI_4;
        let (state, input) = (PlanarTranslation::default(), WedgedInput { turn });
        let acceleration = body.acceleration(0.0, &state, &input);
        assert!((acceleration - Vector2::new(0.0, 2.0)).norm() < 1e-14);
        let reactions = body.reactions(0.0, &state, &input).unwrap();
        // m a - m g
        let whole = Vector2::new(-1.0, 4.0 + 19.6) - Vector2::new(1.0, 0.0);
        let found = reactions.one + reactions.other;
        assert!((found - whole).norm() < 1e-13, "{turn}: {found} {whole}");
    }
}

// the angular velocity in world axes is kept by moments in body axes
rigid_body!(Turned {
    motion: rotation,
    inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
    moments: [load = world(1, 2, 3)[N * m]],
    constraints: [
        about_x = angular_velocity.in_world().x - 0.1[1 / s],
        about_y = angular_velocity.in_world().y,
        about_z = angular_velocity.in_world().z - 1[1 / s ^ 2] * t
    ],
    reactions: [couple = moment(body(_, _, _))],
    outputs: [reactions],
});

// a point is kept where it is by a force in world axes, its velocity written in body axes
rigid_body!(Pinned {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
    points: [pin = (0.1, 0.2, 0.3)],
    fields: [weight = mass * world(1, -9.8[m / s ^ 2], 2)],
    constraints: [
        x = pin.velocity().in_body().x,
        y = pin.velocity().in_body().y,
        z = pin.velocity().in_body().z
    ],
    reactions: [hold = world(_, _, _).at(pin)],
    outputs: [reactions],
});

/// At quarter and third turns, axes of the body are across those of the world.
#[test]
fn axes_across_axes() {
    let third = Vector3::new(1.0, 1.0, 1.0).normalize() * core::f64::consts::TAU / 3.0;
    let quarter = core::f64::consts::FRAC_PI_2;
    let quarters = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| axis * quarter);
    for turn in quarters.into_iter().chain([third, -third, third / 2.0]) {
        for times in 0..4 {
            let attitude = UnitQuaternion::from_scaled_axis(turn * f64::from(times));
            let state = Rotation {
                attitude,
                ..Rotation::default()
            };
            let body = Turned::default();
            let acceleration = attitude * body.acceleration(0.0, &state, &());
            assert!((acceleration - Vector3::z()).norm() < 1e-14);
            let couple = body.reactions(0.0, &state, &()).unwrap().couple;
            let moments = Vector3::new(0.3, 0.4, 0.5);
            let rate = attitude.inverse() * acceleration;
            let needed = attitude * moments.component_mul(&rate) - Vector3::new(1.0, 2.0, 3.0);
            assert!((couple - needed).norm() < 1e-13);

            let state = Spatial {
                attitude,
                ..Spatial::default()
            };
            let body = Pinned::default();
            let acceleration = body.acceleration(0.0, &state, &());
            let arm = attitude * Vector3::new(0.1, 0.2, 0.3);
            let swept = (attitude * acceleration.angular).cross(&arm);
            assert!((acceleration.linear + swept).norm() < 1e-13);
            assert!(body.reactions(0.0, &state, &()).is_ok());
        }
    }
}

// a table on two legs that rub; either leg may stand below G, and either may be without friction
rigid_body!(Table {
    motion: planar,
    params: [mu, left_at[m], right_at[m]],
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    points: [left = (-left_at, -0.3), right = (right_at, -0.3)],
    fields: [weight = mass * world(0.5, -9.8)],
    constraints: [turn = attitude, floor = position.in_world().y - 0.3],
    reactions: [
        left_leg = world(0, _).at(left),
        right_leg = world(0, _).at(right)
    ],
    joint_forces: [
        left_rub = (-mu * left_leg.in_world().y * world(1, 0)).at(left),
        right_rub = (-(1 - mu) * right_leg.in_world().y * world(1, 0)).at(right)
    ],
    outputs: [reactions],
});

#[test]
fn friction_that_may_vanish() {
    for mu in [0.0, 1.0, 0.5] {
        for (left_at, right_at) in [(0.5, 0.5), (0.0, 0.5), (0.5, 0.0), (0.0, 1.0)] {
            let moments = [-left_at - 0.3 * mu, right_at - 0.3 * (1.0 - mu)];
            let legs = Matrix2::new(1.0, 1.0, moments[0], moments[1]);
            let params = TableParams {
                mu,
                left_at,
                right_at,
            };
            let Some(inverse) = legs.try_inverse() else {
                assert!(Table::new(params).is_err());
                continue;
            };
            let expected = inverse * Vector2::new(19.6, 0.0);
            let state = Planar {
                position: [0.0, 0.3].into(),
                ..Planar::default()
            };
            let table = Table::new(params).unwrap();
            let found = table.reactions(0.0, &state, &()).unwrap();
            let found = Vector2::new(found.left_leg.y, found.right_leg.y);
            assert!(
                (found - expected).norm() < 1e-12,
                "{mu} {left_at} {right_at}"
            );
            let rubbing = mu * expected.x + (1.0 - mu) * expected.y;
            let acceleration = table.acceleration(0.0, &state, &());
            assert!((acceleration.linear.x - 0.5 + rubbing / 2.0).abs() < 1e-12);
        }
    }
}

// what may be none, and what is small beside the others
rigid_body!(Sloped {
    motion: planar_translation,
    params: [a, b],
    mass: 2[kg],
    forces: [first = _ * world(1 - a, b), second = _ * world(1, 0.3)],
    outputs: [inverse],
});

rigid_body!(Small {
    motion: planar_translation,
    params: [a, b],
    mass: 2[kg],
    forces: [first = _ * world(1e-18, b), second = _ * world(a, 0.3 * a)],
    outputs: [inverse],
});

rigid_body!(Tilted {
    motion: planar_translation,
    params: [tilt[rad]],
    mass: 2[kg],
    forces: [
        first = _ * world((0.5 * 3.141592653589793[rad] + tilt).cos(), 1),
        second = _ * world(1, 0.3)
    ],
    outputs: [inverse],
});

#[test]
fn differences_and_small_numbers_are_no_pivots() {
    let acceleration = Vector2::new(1.0, 2.0);
    let state = PlanarTranslation::default();
    for (a, b) in [(1.0, 1.0), (1.0 + 1e-15, 1.0), (0.0, 1.0), (0.5, -2.0)] {
        let body = Sloped::new(SlopedParams { a, b }).unwrap();
        let drives = body.inverse(0.0, &state, &acceleration, &());
        let sizes = Matrix2::new(1.0 - a, 1.0, b, 0.3).try_inverse().unwrap() * acceleration * 2.0;
        let first = Vector2::new(1.0 - a, b) * sizes.x;
        assert!((drives.first - first).norm() < 1e-14, "{a} {b}");
        let body = Small::new(SmallParams { a: 0.7, b }).unwrap();
        let drives = body.inverse(0.0, &state, &acceleration, &());
        assert!(
            (drives.first - Vector2::new(0.0, 3.4)).norm() < 1e-14,
            "{b}"
        );
        assert!(
            (drives.second - Vector2::new(2.0, 0.6)).norm() < 1e-14,
            "{b}"
        );
    }
    let body = Tilted::new(TiltedParams { tilt: 0.0 }).unwrap();
    let drives = body.inverse(0.0, &PlanarTranslation::default(), &acceleration, &());
    assert!((drives.first - Vector2::new(0.0, 3.4)).norm() < 1e-14);
    assert!((drives.second - Vector2::new(2.0, 0.6)).norm() < 1e-14);
}

/// Singular as they are written, though not as doubles.
#[test]
fn directions_that_are_one_are_refused() {
    let [a, b] = [Vector3::new(0.1, 0.3, 0.0), Vector3::new(0.3, 0.9, 0.0)];
    let c = Vector3::z();
    assert!(Thrusters::new(ThrustersParams { a, b, c }).is_err());
    let [a, b] = [Vector3::x() * 1e200, Vector3::y() * 1e200];
    assert!(Thrusters::new(ThrustersParams { a, b, c: c * 1e200 }).is_err());
}

// six rotors that tilt
rigid_body!(Hexarotor {
    motion: spatial,
    inputs: [
        a = body(_, _, _),
        b = body(_, _, _),
        c = body(_, _, _),
        d = body(_, _, _),
        e = body(_, _, _),
        f = body(_, _, _)
    ],
    mass: 2[kg],
    inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
    points: [
        right = (1, 0, 0),
        left = (-1, 0, 0),
        front = (0, 1, 0),
        back = (0, -1, 0),
        top = (0, 0, 1),
        below = (0, 0, -1)
    ],
    forces: [
        in_a = (_ * a).at(right),
        in_b = (_ * b).at(left),
        in_c = (_ * c).at(front),
        in_d = (_ * d).at(back),
        in_e = (_ * e).at(top),
        in_f = (_ * f).at(below)
    ],
    outputs: [inverse],
});

/// Directions of 0, 1 and -1 at random, and others.
#[test]
fn six_drives() {
    let mut seed = 5_u64;
    let mut random = || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(seed >> 32).unwrap_or(0)) / f64::from(u32::MAX)
    };
    let (mut solved, mut refused) = (0, 0);
    for case in 0..4000 {
        let mut entry = || match case % 2 {
            0 => (3.0 * random()).floor() - 1.0,
            _ => random() - 0.5,
        };
        let [a, b, c, d, e, f] = [(); 6].map(|()| Vector3::from_fn(|_, _| entry()));
        let places = [Vector3::x(), Vector3::y(), Vector3::z()];
        let places = places.into_iter().flat_map(|place| [place, -place]);
        let mut matrix = nalgebra::Matrix6::zeros();
        for (column, (direction, place)) in [a, b, c, d, e, f].into_iter().zip(places).enumerate() {
            let moment = place.cross(&direction);
            matrix
                .fixed_view_mut::<3, 1>(0, column)
                .copy_from(&direction);
            matrix.fixed_view_mut::<3, 1>(3, column).copy_from(&moment);
        }
        let sizes = matrix.singular_values();
        let condition = sizes[0] / sizes[5];
        let acceleration = SpatialAcceleration {
            linear: [1.0, 2.0, 3.0].into(),
            angular: [0.5, -0.7, 0.2].into(),
        };
        let input = HexarotorInput { a, b, c, d, e, f };
        let state = Spatial::default();
        let found = Hexarotor::default().inverse(0.0, &state, &acceleration, &input);
        if condition > 1e12 {
            assert!(found.is_err());
            refused += 1;
        } else if condition < 1e6 {
            let drives = found.unwrap();
            let forces = [
                drives.in_a,
                drives.in_b,
                drives.in_c,
                drives.in_d,
                drives.in_e,
                drives.in_f,
            ];
            let whole: Vector3<f64> = forces.into_iter().sum();
            let scale = forces
                .into_iter()
                .map(|force| force.norm())
                .fold(1.0, f64::max);
            let off = (whole - acceleration.linear * 2.0).norm();
            assert!(off < 1e-14 * condition * scale, "{case} {condition}: {off}");
            solved += 1;
        }
    }
    assert!(solved > 1500 && refused > 300, "{solved} {refused}");
}

// velocities in world axes are kept by a force and a moment in body axes
rigid_body!(Frozen {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
    points: [p = (0.1, 0.2, 0.3)],
    fields: [weight = mass * world(0, 0, -9.8)],
    constraints: [here = velocity, still = angular_velocity],
    reactions: [force = body(_, _, _).at(p), couple = moment(body(_, _, _))],
    outputs: [reactions],
});

#[test]
fn six_reactions() {
    for axis in [
        Vector3::x(),
        Vector3::y(),
        Vector3::z(),
        Vector3::new(1.0, 1.0, 1.0),
    ] {
        for twelfth in 0..12 {
            let turn = f64::from(twelfth) * core::f64::consts::FRAC_PI_6;
            let attitude = UnitQuaternion::from_scaled_axis(axis.normalize() * turn);
            let state = Spatial {
                attitude,
                ..Spatial::default()
            };
            let body = Frozen::default();
            let found = body.reactions(0.0, &state, &()).unwrap();
            assert!((found.force - Vector3::z() * 19.6).norm() < 1e-12);
            let arm = attitude * Vector3::new(0.1, 0.2, 0.3);
            let off = (found.couple + arm.cross(&found.force)).norm();
            assert!(
                off < 1e-12,
                "{axis} {twelfth}: {off:e} {} {}",
                found.couple,
                found.force
            );
            let acceleration = body.acceleration(0.0, &state, &());
            assert!(acceleration.linear.norm() + acceleration.angular.norm() < 1e-12);
        }
    }
}
