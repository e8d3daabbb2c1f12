//! F08, H2: solids compared with published numbers, and rotated as the runtime rotates tensors.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use newton_euler::inertia::InertiaTensor;
use newton_euler::prelude::*;

use crate::reference::{number, numbers, statement};
use crate::tensor::{is, is_diagonal, tensor, turn};

/// Bodies of 2 kg that turn.
macro_rules! bodies {
    ($($name:ident { $($inertia:tt)+ })+) => {
        mod solids {
            $(newton_euler::rigid_body!($name {
                motion: rotation,
                mass: 2[kg],
                inertia: $($inertia)+,
                outputs: [momentum],
            });)+
        }
    };
}

bodies! {
    Cuboid { cuboid(0.3[m], 0.4[m], 0.5[m]) }
    Sphere { sphere(0.3[m]) }
    Shell { shell(30[cm]) }
    Cylinder { cylinder(0.3[m], 0.5[m]) }
    Tube { tube(0.2[m], 0.3[m], 0.5[m]) }
    Cone { cone(0.3[m], 0.5[m]) }
    Ellipsoid { ellipsoid(0.3[m], 0.4[m], 0.5[m]) }
    Disc { disc(0.3[m]) }
    Torus { torus(0.3[m], 0.1[m]) }
    Along { cylinder(0.3[m], 0.5[m]).along(body(-3, 0, 0)) }
    Quarter { cuboid(0.3[m], 0.4[m], 0.5[m]).turned(body(0, 2, 0), 90[deg]) }
    Half { cuboid(0.3[m], 0.4[m], 0.5[m]).turned(body(1, 1, 0), PI) }
    Spun { cylinder(0.3[m], 0.5[m]).turned(body(0, 0, 1), 0.4) }
    Ball { sphere(0.3[m]).turned(body(1, 2, 3), 1) }
    Slanted { cylinder(0.3[m], 0.5[m]).along(body(1, 2, 2)) }
    Turned { ellipsoid(0.3[m], 0.4[m], 0.5[m]).turned(body(1, -2, 0.5), 0.7) }
    Twice { tensor { xx: 0.3, yy: 0.4, zz: 0.5, xy: 0.05, yz: -0.02, zx: 0.03 }
        .turned(body(1, -2, 0.5), 0.7)
        .turned(body(0, 0, 1), -1.2) }
}

#[test]
fn f08_solids() {
    let solids = statement("solids");
    let axial = |key: &str| {
        let [axial, across] = numbers::<2>(&solids[key]);
        [across, across, axial]
    };
    let ball = |key: &str| [number(&solids[key]); 3];
    is_diagonal(
        &tensor(&solids::Cuboid {}),
        numbers(&solids["box m=2,(a,b,c)=(.3,.4,.5)"]),
    );
    is_diagonal(&tensor(&solids::Sphere {}), ball("solid sphere m=2,r=.3"));
    is_diagonal(&tensor(&solids::Shell {}), ball("spherical shell m=2,r=.3"));
    is_diagonal(
        &tensor(&solids::Cylinder {}),
        axial("solid cylinder m=2,r=.3,h=.5 (Jz,Jx)"),
    );
    is_diagonal(
        &tensor(&solids::Tube {}),
        axial("tube m=2 r1=.2 r2=.3 h=.5 (Jz,Jx)"),
    );
    is_diagonal(
        &tensor(&solids::Cone {}),
        axial("solid cone m=2,r=.3,h=.5 about G (Jz,Jx)"),
    );
    is_diagonal(
        &tensor(&solids::Ellipsoid {}),
        numbers(&solids["solid ellipsoid m=2,(a,b,c)=(.3,.4,.5)"]),
    );
    is_diagonal(
        &tensor(&solids::Disc {}),
        axial("thin disc m=2 r=.3 (Jz,Jx=Jz/2)"),
    );
    is_diagonal(
        &tensor(&solids::Torus {}),
        axial("torus m=2 R=.3 r=.1 (Jz,Jx)"),
    );
}

/// Quarter turns exchange moments and equal moments stay equal, in every bit.
#[test]
fn turns_are_exact_where_they_can_be() {
    let [x, y, z] = <[f64; 3]>::from(tensor(&solids::Cuboid {}).diagonal());
    assert_eq!(
        tensor(&solids::Quarter {}),
        Matrix3::from_diagonal(&[z, y, x].into())
    );
    assert_eq!(
        tensor(&solids::Half {}),
        Matrix3::from_diagonal(&[y, x, z].into())
    );
    let [across, _, axial] = <[f64; 3]>::from(tensor(&solids::Cylinder {}).diagonal());
    assert_eq!(
        tensor(&solids::Along {}),
        Matrix3::from_diagonal(&[axial, across, across].into())
    );
    assert_eq!(tensor(&solids::Spun {}), tensor(&solids::Cylinder {}));
    assert_eq!(tensor(&solids::Ball {}), tensor(&solids::Sphere {}));
}

#[test]
fn turns_follow_the_right_hand() {
    let rotated =
        |inertia: &InertiaTensor, turn: &UnitQuaternion<f64>| inertia.rotated(turn).matrix();
    let inertia = |matrix: Matrix3<f64>| InertiaTensor::from_matrix(&matrix).unwrap();
    let [first, second] = [turn([1.0, -2.0, 0.5], 0.7), turn([0.0, 0.0, 1.0], -1.2)];
    let ellipsoid = inertia(tensor(&solids::Ellipsoid {}));
    is(
        &tensor(&solids::Turned {}),
        &rotated(&ellipsoid, &first),
        4e-16,
    ); // entries to 0.16, some ten roundings
    let written = InertiaTensor::tensor(0.3, 0.4, 0.5, 0.05, -0.02, 0.03).unwrap();
    is(
        &tensor(&solids::Twice {}),
        &rotated(&written, &(second * first)),
        1e-15,
    );
    let direction = Vector3::new(1.0, 2.0, 2.0) / 3.0;
    let upright = UnitQuaternion::rotation_between(&Vector3::z(), &direction).unwrap();
    let cylinder = inertia(tensor(&solids::Cylinder {}));
    is(
        &tensor(&solids::Slanted {}),
        &rotated(&cylinder, &upright),
        1e-16,
    );
}

/// Cuboids whose sides a = 1 and b = 1 + `$by` are nearly equal.
macro_rules! nearly_square {
    ($($module:ident: $by:tt);+ $(;)?) => {
        $(mod $module {
            newton_euler::rigid_body!(Plate {
                motion: rotation,
                mass: 3[kg],
                inertia: cuboid(1[m], 1 + $by, 0.2[m]),
            });
        })+

        #[test]
        fn h2_nearly_equal_sides() {
            let state = Rotation { angular_velocity: [1.0, 1.0, 0.0].into(), ..Rotation::default() };
            $({
                let computed = $module::Plate {}.acceleration(0.0, &state, &()).z;
                // (J_x - J_y) / J_z = (b - a) (b + a) / (a^2 + b^2)
                let by: f64 = $by;
                let expected = by * (2.0 + by) / (2.0 + by * (2.0 + by));
                assert!((computed - expected).abs() <= 4.0 * f64::EPSILON * expected, "{computed} {expected}");
            })+
        }
    };
}

nearly_square! {
    three: 1e-3;
    six: 1e-6;
    nine: 1e-9;
    twelve: 1e-12;
    fourteen: 1e-14;
}
