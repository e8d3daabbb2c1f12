//! Uniform fields on charges, (34.7) to (34.9): published numbers, and what such a field does not
//! do.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{UnitQuaternion, Vector2, Vector3};
use newton_euler::field::Charges;
use newton_euler::operations::Operations;
use newton_euler::{integrate::cf4, prelude::*};
use proptest::prelude::*;

use crate::oracle::{planar, rotation, spatial, vectors};
use crate::reference::{number, statement, vector};

mod published {
    newton_euler::rigid_body!(Charged {
        doc: "F19: three charges.",
        motion: spatial,
        mass: 2[kg],
        inertia: principal(1, 2, 2.5)[kg * m ^ 2],
        points: [
            p = (0.1, 0.2, -0.3),
            q = (0.4, -0.1, 0.25),
            r = (-0.15, 0.05, 0.35)
        ],
        fields: [electric =
            world(2.5, -1.25, 4.75)[V / m].on([0.5[C].at(p), -0.2[C].at(q), 0.45[C].at(r)])],
        outputs: [energy, balance],
    });

    newton_euler::rigid_body!(Dipole {
        doc: "F19: two opposite charges.",
        motion: spatial,
        mass: 2[kg],
        inertia: principal(1, 2, 2.5)[kg * m ^ 2],
        points: [p = (0.03, -0.01, 0.02), q = (-0.03, 0.01, -0.02)],
        fields: [electric = world(150, -40, 310)[V / m].on([2[mC].at(p), -2[mC].at(q)])],
        outputs: [energy, balance],
    });
}

mod scenes {
    newton_euler::rigid_body!(Craft {
        doc: "Three fields at once, one of them weight on two masses about G.",
        motion: spatial,
        params: [a = 0.3[C], b = -0.7[C], heavy = 0.5[kg], light = 0.25[kg]],
        inputs: [e = world(_, _, _)[V / m]],
        mass: heavy + light,
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: -0.12,
            yz: -0.05,
            zx: 0.07
        },
        points: [
            bow = (0.3, 0.1, -0.2),
            stern = (-0.5, 0.4, 0),
            near = (0.5, 0, -0.25),
            far = (-1, 0, 0.5)
        ],
        fields: [
            steady = e.on([a.at(bow), b.at(stern), (a * b / 1[C]).at(near)]),
            shaken = (world(0, 3, 1)[V / m] * (3 * t).sin()).on([b.at(bow)]),
            weight = world(0, 0, -9.80665)[m / s ^ 2].on([heavy.at(near), light.at(far)]),
        ],
        outputs: [energy, balance],
    });

    newton_euler::rigid_body!(Raft {
        motion: planar,
        mass: 2,
        inertia: 0.6,
        points: [p = (0.5, 0.1), q = (-0.2, 0.3)],
        fields: [electric = world(2, -3).on([0.4.at(p), -1.5.at(q)])],
        outputs: [energy, balance],
    });

    newton_euler::rigid_body!(Needle {
        motion: rotation,
        inertia: principal(1.3, 1.7, 2.1),
        points: [p = (0.5, 0.1, 0), q = (-0.2, 0.3, 0.4)],
        fields: [electric = world(2, -3, 1).on([0.4.at(p), -1.5.at(q)])],
        outputs: [energy, balance],
    });

    newton_euler::rigid_body!(Hung {
        motion: fixed_point(p),
        mass: 2,
        inertia: principal(1.3, 1.7, 2.1),
        points: [p = (0.5, 0.1, 0), q = (-0.2, 0.3, 0.4)],
        fields: [electric = world(2, -3, 1).on([0.4.at(p), -1.5.at(q)])],
        reactions: [thread = world(_, _, _).at(p)],
        outputs: [energy, balance, reactions],
    });

    newton_euler::rigid_body!(Bead {
        motion: translation,
        mass: 2,
        points: [p = (0.5, 0, 0), q = (-0.5, 0, 0)],
        fields: [electric = world(2, -3, 1).on([0.5.at(p), 0.5.at(q)])],
        outputs: [balance],
    });
}

/// F19: the charges, and the same numbers from (34.9).
#[test]
fn charges_in_a_field() {
    let given = statement("F19 uniform field");
    let body = published::Charged {};
    let wrench = body.applied(0.0, &Spatial::default(), &());
    assert!((wrench.force - vector(&given["F"])).amax() < 1e-12);
    assert!((wrench.moment - vector(&given["K=sum r x eE"])).amax() < 1e-12);
    let center = vector(&given["r0=(34.8)"]);
    assert!((center.cross(&wrench.force) - wrench.moment).amax() < 1e-12);
    let acceleration = body.acceleration(0.0, &Spatial::default(), &());
    assert!((acceleration.linear * number(&2.into()) - wrench.force).amax() < 1e-12);
}

/// F19: no net charge, and no force: a couple, the same about every pole.
#[test]
fn a_dipole_is_a_couple() {
    let given = statement("F19 pure dipole, sum e=0");
    let body = published::Dipole {};
    let state = Spatial {
        position: Vector3::new(3e5, -2.0, 7.0),
        velocity: Vector3::new(1.0, 2.0, 3.0),
        ..Spatial::default()
    };
    let wrench = body.applied(0.0, &state, &());
    assert_eq!(wrench.force, Vector3::zeros());
    assert!((wrench.moment - vector(&given["K=p x E"])).amax() < 1e-12 * 0.02);
    let skipped = published::Dipole::SKIPPED;
    assert!(
        skipped.contains(&"the force of `electric`: its potential does not depend on the position")
    );
    assert_eq!(body.acceleration(0.0, &state, &()).linear, Vector3::zeros());
}

fn in_world(points: &[(f64, [f64; 3])], q: &UnitQuaternion<f64>) -> Charges {
    Charges::from_points(points.iter().map(|(e, r)| (*e, q * Vector3::from(*r))))
}

proptest! {
    /// Against the runtime's charges, which know nothing of the macro.
    #[test]
    fn several_fields_at_once(state in spatial(), e in vectors(5.0), t in 0.0..5.0) {
        let (body, input) = (scenes::Craft::default(), scenes::CraftInput { e });
        let q = state.attitude;
        let steady = in_world(
            &[(0.3, [0.3, 0.1, -0.2]), (-0.7, [-0.5, 0.4, 0.0]), (-0.21, [0.5, 0.0, -0.25])],
            &q,
        );
        let shaken = in_world(&[(-0.7, [0.3, 0.1, -0.2])], &q);
        let weight = in_world(&[(0.5, [0.5, 0.0, -0.25]), (0.25, [-1.0, 0.0, 0.5])], &q);
        let fields = [
            (steady, e),
            (shaken, Vector3::new(0.0, 3.0, 1.0) * f64::sin(3.0 * t)),
            (weight, Vector3::new(0.0, 0.0, -9.80665)),
        ];
        let loads = body.loads(t, &state, &input);
        let mut energy = 0.0;
        for (load, (charges, field)) in loads.iter().zip(&fields) {
            prop_assert!((load.force - charges.force(field)).amax() < 1e-13 * 10.0);
            prop_assert!((load.moment - charges.moment(field)).amax() < 1e-13 * 10.0);
            energy += charges.potential_energy(field, &state.position);
        }
        prop_assert!((body.potential_energy(t, &state, &input) - energy).abs() < 1e-12 * 100.0);
        // Weight has no moment about G: its masses have none.
        prop_assert_eq!(loads[2].moment, Vector3::zeros());
        prop_assert_eq!(loads.map(|load| load.name), ["steady", "shaken", "weight"]);
    }

    #[test]
    fn in_the_plane(state in planar()) {
        let body = scenes::Raft {};
        let turn = nalgebra::Rotation2::new(state.angle);
        let dipole = turn * (Vector2::new(0.5, 0.1) * 0.4 - Vector2::new(-0.2, 0.3) * 1.5);
        let field = Vector2::new(2.0, -3.0);
        let PlanarWrench { force, moment } = body.applied(0.0, &state, &());
        prop_assert!((force - field * (0.4 - 1.5)).amax() < 1e-14 * 10.0);
        prop_assert!((moment - dipole.perp(&field)).abs() < 1e-14 * 10.0);
    }

    /// Where only the attitude counts, and where a point is held.
    #[test]
    fn of_a_body_that_only_turns(state in rotation()) {
        let points = [(0.4, [0.5, 0.1, 0.0]), (-1.5, [-0.2, 0.3, 0.4])];
        let charges = in_world(&points, &state.attitude);
        let field = Vector3::new(2.0, -3.0, 1.0);
        let needle = scenes::Needle {}.applied(0.0, &state, &());
        prop_assert!((needle - charges.moment(&field)).amax() < 1e-13 * 5.0);
        let energy = scenes::Needle {}.potential_energy(0.0, &state, &());
        prop_assert!((energy + charges.dipole().dot(&field)).abs() < 1e-13 * 5.0);
        let hung = scenes::Hung {};
        let wrench = hung.applied(0.0, &state, &());
        prop_assert!((wrench.force - charges.force(&field)).amax() < 1e-13 * 5.0);
        prop_assert!((wrench.moment - charges.moment(&field)).amax() < 1e-13 * 5.0);
        let acceleration = hung.acceleration(0.0, &state, &());
        let reactions = hung.reactions(0.0, &state, &());
        let residual = hung.residual(0.0, &state, &acceleration, &reactions, &());
        prop_assert!(residual.force.norm() < 1e-12 && residual.moment.norm() < 1e-12, "{residual:?}");
    }
}

#[test]
fn energy_is_conserved() {
    let body = published::Charged {};
    let start = Spatial {
        attitude: UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -0.3, 1.1)),
        angular_velocity: Vector3::new(1.5, -0.8, 2.2),
        ..Spatial::default()
    };
    let total = |s: &Spatial| body.kinetic_energy(s) + body.potential_energy(0.0, s, &());
    let drift = |steps| (total(&cf4(&body, &start, &(), 0.0..4.0, steps)) - total(&start)).abs();
    let (coarse, fine) = (drift(400), drift(800));
    // Rates to 3 rad/s at steps of 5 ms: (0.015)⁴ = 5e-8 of 10 J.
    assert!(
        fine < 1e-7 && (fine < coarse / 8.0 || fine < 1e-12),
        "{coarse:e}, then {fine:e}"
    );
}

#[test]
fn two_equal_charges_hold_a_bead_straight() {
    // Their moment vanishes, or `translation` would refuse it.
    let wrench = scenes::Bead {}.applied(0.0, &Translation::default(), &());
    assert_eq!(wrench.force, Vector3::new(2.0, -3.0, 1.0));
}

mod counts {
    newton_euler::rigid_body!(Two {
        motion: spatial,
        mass: 2,
        inertia: principal(1, 1, 1),
        points: [p = (0.1, 0.2, -0.3), q = (0.4, -0.1, 0.25)],
        fields: [e = world(2, -1, 4).on([1.at(p), -2.at(q)])],
    });
    newton_euler::rigid_body!(Six {
        motion: spatial,
        params: [a, b, c, d, e, f, g = world(2, -1, 4)],
        mass: 2,
        inertia: principal(1, 1, 1),
        points: [p = (0.1, 0.2, -0.3), q = (0.4, -0.1, 0.25), r = (1, 2, 3)],
        fields: [e = g.on([a.at(p), b.at(q), c.at(r), d.at(p), e.at(q), f.at(r)])],
    });
    newton_euler::rigid_body!(Upright {
        motion: spatial,
        mass: 2,
        inertia: principal(1, 1, 1),
        points: [p = (0.1, 0.2, -0.3), q = (0.4, -0.1, 0.25)],
        fields: [e = world(0, 0, 4).on([1.at(p), -2.at(q)])],
    });
}

/// R14: 27 to turn the field by the quaternion (15 by a matrix, which costs 24), 9 for p × E; however many charges.
#[test]
fn operations_do_not_grow_with_the_charges() {
    let count = |operations: &[Operations]| {
        let found = operations
            .iter()
            .rfind(|row| row.function == "acceleration");
        let row = found.expect("every body has one");
        assert_eq!(
            (row.div, row.sqrt, row.trig, row.other),
            (0, 0, 0, 0),
            "{row}"
        );
        row.mul + row.add
    };
    assert!(count(counts::Two::OPERATIONS) <= 36);
    assert!(count(counts::Six::OPERATIONS) <= 36);
    assert!(count(counts::Upright::OPERATIONS) <= 22);
}

/// Bodies on which a field acts beside what is not known, and without a motion of G.
mod listed {
    newton_euler::rigid_body!(Driven {
        motion: spatial,
        mass: 2[kg],
        inertia: principal(1, 2, 2.5)[kg * m ^ 2],
        points: [p = (0.1, 0.2, -0.3)],
        forces: [thrust = body(_, _, _)],
        moments: [wheels = body(_, _, _)],
        fields: [
            electric = world(3, 0, 0)[V / m].on([2[C].at(p)]),
            weight = mass * world(0, 0, -9.8)
        ],
        potentials: [height = 1[N] * position.in_world().z],
        outputs: [balance, inverse],
    });

    newton_euler::rigid_body!(Turning {
        motion: rotation,
        inertia: principal(1, 2, 2.5)[kg * m ^ 2],
        points: [p = (0.1, 0, 0)],
        fields: [electric = world(0, 3, 0)[V / m].on([2[C].at(p)])],
        outputs: [balance],
    });

    newton_euler::rigid_body!(Hinged {
        motion: fixed_axis(hinge, body(0, 0, 1)),
        inputs: [e[C]],
        mass: 2[kg],
        inertia: principal(1, 2, 2.5)[kg * m ^ 2],
        points: [hinge = (0.3, 0.7, 0), tip = (-0.1, 0.2, 0)],
        fields: [electric = world(3, -7, 0)[V / m].on([0.1[C].at(hinge), e.at(tip)])],
    });
}

/// Moments of charges are about the point that is held: one that sits there has none, whatever rounding does to two that cancel.
#[test]
fn a_charge_on_the_hinge_does_not_turn() {
    let state = Hinge {
        angle: 0.7,
        angular_velocity: 0.0,
    };
    let e = 1e-20;
    let acceleration = listed::Hinged {}.acceleration(0.0, &state, &listed::HingedInput { e });
    let arm = nalgebra::Rotation2::new(0.7) * Vector2::new(-0.4, -0.5);
    let expected = e * arm.perp(&Vector2::new(3.0, -7.0)) / (2.5 + 2.0 * 0.58);
    assert!((acceleration - expected).abs() < 1e-15 * e);
}

#[test]
fn loads_are_in_order_beside_drives() {
    let loads = listed::Driven {}.loads(0.0, &Spatial::default(), &());
    let names = loads.map(|load| load.name);
    assert_eq!(names, ["electric", "weight", "height"]);
}

#[test]
fn a_field_has_its_force_where_g_does_not_move() {
    let [electric] = listed::Turning {}.loads(0.0, &Rotation::default(), &());
    assert_eq!(electric.force, Vector3::new(0.0, 6.0, 0.0));
    assert!((electric.moment - Vector3::new(0.0, 0.0, 0.6)).norm() < 1e-15);
}

mod parallel {
    newton_euler::rigid_body!(Slide {
        doc: "In axes that never rotate, a field may be written in those of the body.",
        motion: planar_translation,
        mass: 2[kg],
        points: [g = (0, 0)],
        fields: [electric = body(1, 3)[V / m].on([0.5[C].at(g), 0.2[C].at(g)])],
        outputs: [energy],
    });
}

#[test]
fn axes_that_never_rotate_are_those_of_the_world() {
    let state = PlanarTranslation {
        position: [1.0, 2.0].into(),
        ..Default::default()
    };
    let slide = parallel::Slide::default();
    let motion = slide.acceleration(0.0, &state, &());
    assert!((motion - Vector2::new(0.35, 1.05)).amax() < 1e-15);
    let energy = slide.potential_energy(0.0, &state, &());
    assert!((energy + 0.7 * (1.0 + 3.0 * 2.0)).abs() < 1e-14, "{energy}");
}
