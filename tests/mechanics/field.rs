//! Uniform fields on charges: F19, H14.

#![allow(
    clippy::float_cmp,
    clippy::cast_precision_loss,
    clippy::excessive_precision,
    reason = "what is exact is compared exactly, with all digits of the references"
)]
use nalgebra::Vector3;
use newton_euler::field::Charges;
use newton_euler::inertia::InertiaTensor;
use newton_euler::prelude::*;
use proptest::prelude::*;

use crate::reference::{number, statement, vector};

#[test]
fn with_a_net_charge() {
    let expected = statement("F19 uniform field");
    let list = expected["charges"].as_array().unwrap();
    let points = list.iter().map(|pair| (number(&pair[0]), vector(&pair[1])));
    let charges = Charges::from_points(points);
    let field = vector(&expected["E"]);
    let center = charges.center().unwrap();
    assert_eq!(charges.net(), 0.75);
    // The charges and coordinates are rounded: half a unit of numbers below 1, products with a field below 5.
    assert!((center - vector(&expected["r0=(34.8)"])).amax() < 1e-16);
    assert_eq!(charges.force(&field), vector(&expected["F"]));
    assert!((charges.moment(&field) - vector(&expected["K=sum r x eE"])).amax() < 1e-15);
    let at_center = Wrench::from_force_at(charges.force(&field), center);
    assert!((at_center.moment - charges.wrench(&field).moment).amax() < 1e-15);
}

#[test]
fn without() {
    let expected = statement("F19 pure dipole, sum e=0");
    let arm = Vector3::new(0.03, -0.01, 0.02);
    let field = vector(&expected["E"]);
    // About another origin: the same.
    for origin in [Vector3::zeros(), Vector3::new(1.0, -2.0, 4.0)] {
        let charges = Charges::from_points([(0.002, arm - origin), (-0.002, -arm - origin)]);
        let wrench = charges.wrench(&field);
        assert_eq!((wrench.force, charges.center()), (Vector3::zeros(), None));
        // Positions rounded at 4: 4e-16 times 0.002 times 310.
        assert!((wrench.moment - vector(&expected["K=p x E"])).amax() < 1e-15);
        assert!(wrench.moment.iter().all(|component| component.is_finite()));
    }
    assert_eq!(Charges::from_points([]).center(), None);
    assert_eq!(Charges::from_points([]).wrench(&field), Wrench::default());
}

/// H14: r₀ runs away as the charge goes to zero, the moment does not notice.
#[test]
fn nearly_neutral() {
    let [arm, field] = [
        Vector3::new(0.3, -0.1, 0.2),
        Vector3::new(150.0, -40.0, 310.0),
    ];
    let moment = (arm * 2.0).cross(&field);
    for excess in [1e-3, 1e-9, 1e-12, 4e-15] {
        let charges = Charges::from_points([(1.0 + excess, arm), (-1.0, -arm)]);
        let center = charges.center().unwrap();
        assert!((center * charges.net() - arm * (2.0 + excess)).amax() < 1e-15);
        assert!((charges.moment(&field) - moment).amax() <= 100.0 * excess + 1e-13);
        let at_center = Wrench::from_force_at(charges.force(&field), center).moment;
        assert!((at_center - charges.moment(&field)).amax() < 1e-13);
    }
    // One unit in the last place of one of two charges: the sum may be their rounding.
    let charges = Charges::from_points([(1.0 + f64::EPSILON, arm), (-1.0, -arm)]);
    assert_eq!(charges.net(), f64::EPSILON);
    assert_eq!(charges.center(), None);
}

/// Sums that cancel: compared with whole numbers, where nothing is rounded.
#[test]
fn no_digits_lost() {
    let at = |x: f64| Vector3::new(x, -x, 0.5 * x);
    let terms = [
        (3.0, 1e15 + 1.0),
        (-5.0, 6e14),
        (1e8, 12_345.0),
        (-1e8, 12_344.0),
    ];
    let charges = Charges::from_points(terms.map(|(e, x)| (e, at(x))));
    assert_eq!(charges.net(), -2.0);
    // 3e15 + 3 - 3e15 + 1e8
    assert_eq!(charges.dipole(), at(100_000_003.0));
    assert_eq!(charges.center(), Some(at(-50_000_001.5)));
    // With the small one between two that cancel and are 1e20 times larger, a plain sum is 0.
    let charges = Charges::from_points([(1e20, at(1.0)), (1.0, at(3.0)), (-1e20, at(1.0))]);
    assert_eq!((charges.net(), charges.dipole()), (1.0, at(3.0)));
    assert_eq!(charges.center(), None); // those of 1e20 were hardly given to 1
}

fn some_vector() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0).prop_map(Vector3::from)
}

proptest! {
    /// The field on the body is the sum over its charges; the energy is the sum of theirs and the work of the field.
    #[test]
    fn charge_by_charge(
        points in prop::collection::vec((-1.0..1.0, some_vector()), 1..9),
        field in some_vector(),
        position in some_vector(),
    ) {
        let charges = Charges::from_points(points.iter().copied());
        let sum: Wrench = points.iter().map(|(e, r)| Wrench::from_force_at(field * *e, *r)).sum();
        let wrench = charges.wrench(&field);
        // Sums of up to sixteen products below 1.
        prop_assert!((wrench.force - sum.force).amax() < 1e-14);
        prop_assert!((wrench.moment - sum.moment).amax() < 1e-14);
        let energy: f64 = points.iter().map(|(e, r)| -e * field.dot(&(position + r))).sum();
        prop_assert!((charges.potential_energy(&field, &position) - energy).abs() < 2e-14);
    }

    /// Gravity: e = m, r₀ = G, and no moment about it.
    #[test]
    fn weight(points in prop::collection::vec((0.1..2.0, some_vector()), 1..9), g in some_vector(), far in -1e7..1e7) {
        let offset = Vector3::new(far, 0.0, -far);
        let points: Vec<_> = points.into_iter().map(|(m, r)| (m, r + offset)).collect();
        let charges = Charges::from_points(points.iter().copied());
        let body = InertiaTensor::from_points(points.iter().copied()).unwrap();
        // One rounding of the quotient, and two in the other way.
        prop_assert!((charges.center().unwrap() - body.center).amax() <= 2.0 * f64::EPSILON * (far.abs() + 1.0));
        prop_assert!((charges.net() - body.mass).abs() < 1e-14);
        let about = |origin: Vector3<f64>| Charges::from_points(points.iter().map(|(m, r)| (*m, r - origin)));
        let about_center = about(charges.center().unwrap());
        // The center is rounded: 1e7 eps/2, times masses up to 18.
        prop_assert!(about_center.moment(&g).amax() < 1e-7);
    }
}

rigid_body!(Sled {
    motion: planar_translation,
    mass: 2[kg],
    fields: [weight = mass * body(0, -9.81[m / s ^ 2])],
    outputs: [energy],
});

rigid_system!(Sleds {
    motion: planar,
    bodies: [
        sled {
            mass: 2[kg],
            inertia: 1[kg * m ^ 2],
            fields: [weight = mass * body(0, -9.81[m / s ^ 2])],
        },
        top {
            mass: 2[kg],
            inertia: 1[kg * m ^ 2],
            points: [pin = (0, 0)],
            fields: [thrust = mass * body(0, -9.81[m / s ^ 2])],
        },
    ],
    joints: [
        base = translation(sled),
        turn = revolute(world(0, 0), top.pin)
    ],
    outputs: [energy],
});

/// The axes of a body that cannot rotate are those of the world.
#[test]
fn fields_in_axes_that_do_not_rotate_have_a_potential() {
    let base = PlanarTranslation {
        position: [1.0, 2.0].into(),
        ..PlanarTranslation::default()
    };
    let alone = Sled::default().potential_energy(0.0, &base, &());
    assert_eq!(alone, 2.0 * 9.81 * 2.0);
    let turn = Hinge {
        angle: 0.3,
        angular_velocity: 0.0,
    };
    let together = Sleds::default().potential_energy(0.0, &SledsState { base, turn }, &());
    assert_eq!(together, 2.0 * 9.81 * 2.0);
}
