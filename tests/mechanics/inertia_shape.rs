//! The kinds of bodies that tensors belong to: symmetry and extent, in any axes and at any scale.

#![allow(
    clippy::float_cmp,
    clippy::cast_precision_loss,
    clippy::excessive_precision,
    reason = "what is exact is compared exactly, with all digits of the references"
)]
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::inertia::{Extent, InertiaTensor, Symmetry};
use proptest::prelude::*;

fn principal(x: f64, y: f64, z: f64) -> InertiaTensor {
    InertiaTensor::principal(x, y, z).unwrap()
}

#[test]
fn along_the_axes() {
    use Extent::{Planar, Point, Rod, Solid};
    use Symmetry::{General, Spherical, Symmetric};
    let [x, y, z] = [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()];
    for (moments, symmetry, extent) in [
        ([0.0, 0.0, 0.0], Spherical, Point),
        ([2.0, 2.0, 2.0], Spherical, Solid),
        ([2.0, 2.0, 3.0], Symmetric { axis: z }, Solid),
        ([1.0, 2.0, 2.0], Symmetric { axis: x }, Solid),
        ([2.0, 1.0, 2.0], Symmetric { axis: y }, Solid),
        ([1.0, 1.0, 2.0], Symmetric { axis: z }, Planar { normal: z }),
        ([2.0, 1.0, 1.0], Symmetric { axis: x }, Planar { normal: x }),
        ([1.0, 3.0, 2.0], General, Planar { normal: y }),
        ([0.1, 0.2, 0.1 + 0.2], General, Planar { normal: z }),
        ([0.1, 0.2, 0.3], General, Planar { normal: z }),
        ([2.0, 3.0, 4.0], General, Solid),
        ([0.0, 5.0, 5.0], Symmetric { axis: x }, Rod { axis: x }),
        ([5.0, 0.0, 5.0], Symmetric { axis: y }, Rod { axis: y }),
        ([5.0, 5.0, 0.0], Symmetric { axis: z }, Rod { axis: z }),
    ] {
        for decade in [-250, -9, 0, 9, 250] {
            let [a, b, c] = moments.map(|moment| moment * 10f64.powi(decade));
            let body = principal(a, b, c);
            assert_eq!(
                (body.symmetry(), body.extent()),
                (symmetry, extent),
                "{moments:?}"
            );
        }
    }
    // What a tolerance makes of it; of two pairs that pass, the closer one.
    let nearly = principal(1.0, 1.001, 1.003);
    assert_eq!(nearly.symmetry_within(0.0015), Symmetric { axis: z });
    assert_eq!(nearly.symmetry_within(0.0025), Symmetric { axis: z });
    assert_eq!(nearly.symmetry_within(0.0035), Spherical);
    assert_eq!(
        principal(1.0, 1.002, 1.003).symmetry_within(0.0025),
        Symmetric { axis: x }
    );
    assert_eq!(
        principal(1.0, 1.0, 1.99).extent_within(0.01),
        Planar { normal: z }
    );
    // Four units in the last place and no more.
    let above = |units: f64| 1.0 + units * f64::EPSILON;
    assert_eq!(principal(1.0, 1.0, above(4.0)).symmetry(), Spherical);
    assert_eq!(
        principal(1.0, 1.0, above(5.0)).symmetry(),
        Symmetric { axis: z }
    );
}

fn some_attitude() -> impl Strategy<Value = UnitQuaternion<f64>> {
    prop::array::uniform4(-1.0..1.0)
        .prop_map(|[w, x, y, z]| Quaternion::new(w, x, y, z))
        .prop_filter("of some length", |q| q.norm() > 0.1)
        .prop_map(UnitQuaternion::new_normalize)
}

/// Of unit vectors, one is the other or its negative, and its largest component is positive.
fn same_axis(found: &Vector3<f64>, expected: &Vector3<f64>, tolerance: f64) {
    assert!(
        found.cross(expected).norm() < tolerance,
        "{found} {expected}"
    );
    assert!(found[found.iamax()] > 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Turned bodies are still what they are, to the slack of turned tensors; the axis to rounding over the gap.
    #[test]
    fn turned(turn in some_attitude(), a in 0.2..1.0, b in 0.2..1.0, lift in 0.1..1.0, decade in -100..100) {
        let scale = 10f64.powi(decade);
        let body = |x: f64, y: f64, z: f64| principal(x * scale, y * scale, z * scale).rotated(&turn);
        let [x, z] = [turn * Vector3::x(), turn * Vector3::z()];

        // A prolate one: a + lift twice, a once, at most a + a + 2 lift.
        match body(a + lift, a + lift, a).symmetry() {
            Symmetry::Symmetric { axis } => same_axis(&axis, &z, 1e-14 / lift),
            other => prop_assert!(false, "{:?}", other),
        }
        prop_assert_eq!(body(a, a, a).symmetry(), Symmetry::Spherical);
        prop_assert_eq!(body(a + lift, b + lift, a + b).extent(), Extent::Solid);
        match body(a, b, a + b).extent() {
            Extent::Planar { normal } => same_axis(&normal, &z, 1e-13),
            other => prop_assert!(false, "{:?}", other),
        }
        let rod = body(0.0, a, a);
        match (rod.extent(), rod.symmetry()) {
            (Extent::Rod { axis }, Symmetry::Symmetric { axis: same }) => {
                same_axis(&axis, &x, 1e-14);
                prop_assert_eq!(axis, same);
            }
            other => prop_assert!(false, "{:?}", other),
        }
        if (a - b).abs() > 1e-9 {
            prop_assert_eq!(body(a + lift, b + lift, a + b + lift).symmetry(), Symmetry::General);
        }
    }
}
