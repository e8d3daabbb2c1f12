//! Reduction of wrenches: F17, F18, the four cases, at every scale (H13).

#![allow(
    clippy::float_cmp,
    clippy::cast_precision_loss,
    clippy::excessive_precision,
    reason = "what is exact is compared exactly, with all digits of the references"
)]
use nalgebra::{Vector2, Vector3};
use newton_euler::prelude::*;
use newton_euler::wrench::{PlanarReduction, Reduction, Tolerance};
use proptest::prelude::*;

use crate::reference::{number, statement, vector};

fn screw(wrench: &Wrench) -> (Vector3<f64>, Vector3<f64>, f64) {
    match wrench.reduce() {
        Reduction::Screw { line, pitch, .. } => (line.point, line.direction.into_inner(), pitch),
        other => panic!("{other:?}"),
    }
}

/// F17 and F18: the same forces about two poles make one screw.
#[test]
fn worked_screw() {
    let [system, expected] =
        ["F17 origin change", "F18 wrench reduction of the F17 set"].map(statement);
    let [force, about_origin, about_a, a] = ["F", "K", "K'", "a"].map(|name| vector(&system[name]));
    let axis = vector(&expected["axis point closest to origin"]);
    let (point, direction, pitch) = screw(&Wrench {
        force,
        moment: about_origin,
    });
    // Sums of two products of order one over F² = 4.3.
    assert!((point - axis).amax() < 1e-15);
    assert!((pitch - number(&expected["pitch"])).abs() < 2e-16);
    let invariant = number(&expected["invariant K.F/|F|"]);
    assert!((pitch * force.norm() - invariant).abs() < 1e-15);
    assert!((direction * force.norm() - force).amax() < 1e-15);

    let (other, _, same) = screw(&Wrench {
        force,
        moment: about_a,
    });
    assert!((same - pitch).abs() < 1e-15);
    let between = other + a - point; // along the axis
    assert!(between.cross(&direction).norm() < 2e-15);
    assert!(between.norm() > 0.05); // not the same point
}

/// F19, both sets: a uniform field makes one force through r₀, or a couple.
#[test]
fn field_of_a_charge_and_of_a_dipole() {
    let expected = statement("F19 uniform field");
    let [force, moment, center] =
        ["F", "K=sum r x eE", "r0=(34.8)"].map(|name| vector(&expected[name]));
    let Reduction::Force { line, .. } = (Wrench { force, moment }).reduce() else {
        panic!("F is perpendicular to K")
    };
    assert!((center - line.point).cross(&line.direction).norm() < 1e-16);
    let moment = vector(&statement("F19 pure dipole, sum e=0")["K=p x E"]);
    assert_eq!(
        Wrench::from_moment(moment).reduce(),
        Reduction::Couple { moment }
    );
}

#[test]
fn the_four_cases() {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let wrench = |force, moment| Wrench { force, moment };
    let zero = Vector3::zeros();
    assert_eq!(wrench(zero, zero).reduce(), Reduction::Zero);
    assert_eq!(wrench(-zero, -zero).reduce(), Reduction::Zero);
    assert_eq!(wrench(zero, y).reduce(), Reduction::Couple { moment: y });
    // z at x: the moment is -y.
    let Reduction::Force { force, line } = wrench(z * 2.0, y * -6.0).reduce() else {
        panic!()
    };
    assert_eq!(
        (force, line.point, line.direction),
        (z * 2.0, x * 3.0, Vector3::z_axis())
    );
    assert_eq!(line.at(-4.0), Vector3::new(3.0, 0.0, -4.0));
    // Through the pole.
    let Reduction::Force { line, .. } = wrench(z, zero).reduce() else {
        panic!()
    };
    assert_eq!(line.point, zero);
    // Left-handed.
    assert_eq!(screw(&wrench(z * 2.0, y * -6.0 - z)), (x * 3.0, z, -0.5));
    // Along the pole.
    assert_eq!(screw(&wrench(z * 2.0, z)), (zero, z, 0.5));
}

/// What is zero is the caller's to say; a length turns one tolerance into the other.
#[test]
fn tolerances() {
    let wrench = Wrench {
        force: Vector3::new(0.0, 0.0, 1e-3),
        moment: Vector3::new(2.0, 0.0, 1e-6),
    };
    let within = |force, moment| {
        wrench.reduce_within(&Tolerance {
            force,
            moment,
            perpendicular: 0.0,
        })
    };
    assert!(
        matches!(within(0.0, 0.0), Reduction::Screw { pitch, .. } if (pitch - 1e-3).abs() < 1e-18)
    );
    assert!(matches!(within(0.0, 1e-6), Reduction::Force { .. }));
    assert!(matches!(within(1e-3, 0.0), Reduction::Couple { moment } if moment == wrench.moment));
    assert!(matches!(within(1e-3, 1.9), Reduction::Couple { .. }));
    assert_eq!(within(1e-3, 2.1), Reduction::Zero);
    // |F·K| = 5e-7 |F||K|
    for (perpendicular, is_screw) in [(4.9e-7, true), (5.1e-7, false)] {
        let reduced = wrench.reduce_within(&Tolerance {
            perpendicular,
            ..Tolerance::EXACT
        });
        assert_eq!(matches!(reduced, Reduction::Screw { .. }), is_screw);
    }
    let scale = Tolerance::at_scale(100.0, 3.0);
    assert_eq!(scale.moment, 3.0 * scale.force);
    assert_eq!(scale.force, 1600.0 * f64::EPSILON);
}

/// H13: the same line and pitch at every size, to the bit for powers of two.
#[test]
fn every_size() {
    let wrench = Wrench {
        force: Vector3::new(0.5, 1.0, 1.75),
        moment: Vector3::new(0.225, -1.325, 2.05),
    };
    let expected = screw(&wrench);
    for exponent in [-1000, -700, -500, -1, 1, 400, 700, 1000] {
        let factor = 2f64.powi(exponent);
        let scaled = Wrench {
            force: wrench.force * factor,
            moment: wrench.moment * factor,
        };
        assert_eq!(screw(&scaled), expected, "2^{exponent}");
    }
    for decade in [-200, -160, 160, 200] {
        let factor = 10f64.powi(decade);
        let (point, direction, pitch) = screw(&Wrench {
            force: wrench.force * factor,
            moment: wrench.moment * factor,
        });
        assert!((point - expected.0).amax() < 2e-15);
        assert!((direction - expected.1).amax() < 1e-15);
        assert!((pitch - expected.2).abs() < 1e-15);
        // Far and near lines: the moment alone is scaled.
        let (far, _, pitch) = screw(&Wrench {
            force: wrench.force,
            moment: wrench.moment * factor,
        });
        assert!((far / factor - expected.0).amax() < 2e-15);
        assert!((pitch / factor - expected.2).abs() < 1e-15);
    }
    // Beyond all numbers: a couple far away, a force close by.
    let extreme = |force: f64, moment: f64| {
        let [force, moment] = [Vector3::new(0.0, force, force), Vector3::x() * moment];
        Wrench { force, moment }.reduce()
    };
    assert!(matches!(extreme(1e-200, 1e200), Reduction::Couple { .. }));
    assert!(
        matches!(extreme(1e200, 1e-200), Reduction::Force { line, .. } if line.point == Vector3::zeros())
    );
    let along = |force: f64, moment: f64| {
        let [force, moment] = [Vector3::x() * force, Vector3::x() * moment];
        Wrench { force, moment }.reduce()
    };
    assert!(matches!(along(1e200, 1e-200), Reduction::Force { .. }));
    assert!(matches!(along(1e-200, 1e200), Reduction::Couple { .. }));
    assert!(matches!(along(1e-150, 1e150), Reduction::Screw { .. }));
}

/// In the plane: a couple, or a force whose every point gives the moment.
#[test]
fn in_the_plane() {
    let couple = PlanarWrench::from_moment(-2.0);
    assert_eq!(couple.reduce(), PlanarReduction::Couple { moment: -2.0 });
    assert_eq!(PlanarWrench::default().reduce(), PlanarReduction::Zero);
    for decade in [-200, 0, 200] {
        let force = Vector2::new(3.0, -4.0) * 10f64.powi(decade);
        let push = PlanarWrench::from_force_at(force, Vector2::new(0.7, 1.1));
        let PlanarReduction::Force { force: same, point } = push.reduce() else {
            panic!()
        };
        assert_eq!(same, force);
        // The arm without its part along (3, -4)/5: 0.7, 1.1 plus 0.46 (0.6, -0.8).
        assert!((point - Vector2::new(0.976, 0.732)).amax() < 4e-16);
        let tolerance = Tolerance::at_scale(1e18 * force.amax(), 1.0);
        assert_eq!(push.reduce_within(&tolerance), PlanarReduction::Zero);
    }
}

/// By itself, eight units in the last place of |F||K| are none.
#[test]
fn nearly_perpendicular() {
    let reduced = |units: f64| {
        let moment = Vector3::new(units * f64::EPSILON, 1.0, 0.0);
        let force = Vector3::x();
        Wrench { force, moment }.reduce()
    };
    assert!(matches!(reduced(8.0), Reduction::Force { .. }));
    assert!(matches!(reduced(9.0), Reduction::Screw { pitch, .. } if pitch == 9.0 * f64::EPSILON));
}

/// Not finite in, not finite out; no panic.
#[test]
fn not_finite() {
    for bad in [f64::NAN, f64::INFINITY] {
        let [good, bad] = [Vector3::x(), Vector3::new(bad, 1.0, 0.0)];
        for (force, moment) in [(good, bad), (bad, good), (bad, bad)] {
            let found = format!("{:?}", Wrench { force, moment }.reduce());
            assert!(found.contains("NaN") || found.contains("inf"), "{found}");
        }
    }
}

fn some_vector() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0).prop_map(Vector3::from)
}

fn some_force() -> impl Strategy<Value = Vector3<f64>> {
    some_vector().prop_filter("of some size", |v| v.norm() > 0.1)
}

proptest! {
    /// A force on a line, and a couple along it, are found again, at every size; every point of the line will do.
    #[test]
    fn made_and_found(
        force in some_force(),
        at in some_vector(),
        pitch in 0.01..2.0,
        along in -3.0..3.0,
        decades in prop::array::uniform2(-100..100),
    ) {
        let [of_force, of_length] = decades.map(|decade| 10f64.powi(decade));
        let [force, at] = [force * of_force, at * of_length];
        let pitch: f64 = pitch * of_length;
        let couple = Wrench::from_moment(force * pitch);
        let wrench = Wrench::from_force_at(force, at) + couple;
        let Reduction::Screw { force: same, line, pitch: found } = wrench.reduce() else {
            return Err(TestCaseError::fail("no screw"));
        };
        let direction = line.direction.into_inner();
        // A handful of roundings of numbers up to 3, in the cross product over |F| > 0.1 times as much.
        prop_assert_eq!(same, force);
        prop_assert!((found - pitch).abs() < 1e-13 * of_length);
        let unit = force / (force.amax() * (force / force.amax()).norm());
        prop_assert!((direction - unit).amax() < 1e-15);
        prop_assert!((at - line.point).cross(&direction).amax() < 1e-13 * of_length);
        prop_assert!(line.point.dot(&direction).abs() < 1e-13 * of_length);
        for at in [line.point, line.at(along * of_length)] {
            let again = Wrench::from_force_at(force, at) + couple;
            prop_assert!((again.moment - wrench.moment).amax() < 1e-13 * of_force * of_length);
        }
        prop_assert!((wrench.reduce().wrench().moment - wrench.moment).amax() < 1e-13 * of_force * of_length);
    }

    /// With the arm perpendicular, a single force is never mistaken for a screw.
    #[test]
    fn single_forces(force in some_force(), other in some_force(), decade in -150..150) {
        let arm = force.cross(&other);
        prop_assume!(arm.norm() > 1e-3);
        let wrench = Wrench::from_force_at(force * 10f64.powi(decade), arm);
        let Reduction::Force { line, .. } = wrench.reduce() else {
            return Err(TestCaseError::fail("not a force"));
        };
        // |F| > 0.1: of |K|/|F|, a few roundings.
        prop_assert!((line.point - arm).amax() < 1e-14);
    }

    /// Pitch, direction and axis are those of every pole.
    #[test]
    fn any_pole(force in some_force(), moment in some_vector(), pole in some_vector()) {
        let wrench = Wrench { force, moment };
        prop_assume!(force.dot(&moment).abs() > 1e-6);
        let (point, direction, pitch) = screw(&wrench);
        let (moved, _, same) = screw(&wrench.moved(&Vector3::zeros(), &pole));
        prop_assert!((pitch - same).abs() < 1e-13);
        prop_assert!((moved + pole - point).cross(&direction).amax() < 1e-13);
    }
}
