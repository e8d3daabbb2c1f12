//! Potentials: forces and moments compared with published numbers and with differences of the
//! energy; and the energy itself.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{UnitQuaternion, Vector2, Vector3};
use newton_euler::operations::Operations;
use newton_euler::{integrate::cf4, prelude::*};
use proptest::prelude::*;

#[path = "../oracle/mod.rs"]
mod oracle;
#[path = "../reference/mod.rs"]
mod reference;
use oracle::{planar, rotation, spatial, vectors};
use reference::{number, numbers, statement, vector};

/// What one acceleration costs.
fn acceleration(operations: &[Operations]) -> Operations {
    let found = operations.iter().find(|row| row.function == "acceleration");
    *found.expect("every body has one")
}

mod published {
    newton_euler::rigid_body!(Charges {
        doc: "F13, F14: three charges in the central field 1/r.",
        motion: spatial,
        mass: 2,
        inertia: principal(1, 2, 2.5),
        points: [
            p = (0.2, 0, 0.1),
            q = (0, 0.3, -0.2),
            r = (-0.1, -0.2, 0.15)
        ],
        potentials: [central =
            0.3 / p.position().norm() - 0.5 / q.position().norm() + 0.7 / r.position().norm(),],
        outputs: [energy, balance],
    });

    newton_euler::rigid_body!(Satellite {
        doc: "F21: gravity gradient, as the second term of the potential of a distant mass.",
        motion: rotation,
        inputs: [n = world(_, _, _)],
        inertia: principal(120, 150, 90)[kg * m ^ 2],
        params: [mu = 3.986004418e14[m ^ 3 / s ^ 2], radius = 7e6[m]],
        locals: [
            down = n.in_body(),
            along = 120[kg * m ^ 2] * down.x.powi(2)
                + 150[kg * m ^ 2] * down.y.powi(2)
                + 90[kg * m ^ 2] * down.z.powi(2),
        ],
        potentials: [gradient = 1.5 * mu / radius.powi(3) * along],
        outputs: [energy, balance],
    });
}

mod scenes;

/// The gradient of `u` at zero, by differences of order four.
///
/// Energies here are of some hundred joules and change over meters and radians: with h = 2e-3, h⁴ / 30 times a fifth
/// derivative of 1e4 is 5e-9, and rounding, 1e-16 · 1e3 / h, is 5e-11.
fn gradient<const N: usize>(u: impl Fn([f64; N]) -> f64) -> [f64; N] {
    let h = 2e-3;
    core::array::from_fn(|i| {
        let at = |s: f64| {
            let mut x = [0.0; N];
            x[i] = s * h;
            u(x)
        };
        (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h)
    })
}

fn moved(state: &Spatial, [x, y, z, a, b, c]: [f64; 6]) -> Spatial {
    Spatial {
        position: state.position + Vector3::new(x, y, z),
        attitude: UnitQuaternion::from_scaled_axis(Vector3::new(a, b, c)) * state.attitude,
        ..*state
    }
}

fn is_slope(derived: &[f64], slope: &[f64]) -> Result<(), TestCaseError> {
    let size = derived.iter().fold(1.0, |size: f64, f| size.max(f.abs()));
    for (derived, slope) in derived.iter().zip(slope) {
        prop_assert!(
            (derived + slope).abs() < 1e-7 * size,
            "{derived} is not {}",
            -slope
        );
    }
    Ok(())
}

fn flat(wrench: &Wrench) -> [f64; 6] {
    let [f, k] = [wrench.force, wrench.moment];
    [f.x, f.y, f.z, k.x, k.y, k.z]
}

/// F13, F14.
#[test]
fn charges_in_a_central_field() {
    let given = statement("F13/F14 F=-dU/dR, K=-dU/dphi, U=sum e_k/|r_k|, attitude identity");
    let body = published::Charges {};
    let state = Spatial {
        position: vector(&given["R"]),
        ..Spatial::default()
    };
    let energy = body.potential_energy(0.0, &state, &());
    assert!((energy - number(&given["U"])).abs() < 1e-15);
    let wrench = body.applied(0.0, &state, &());
    assert!((wrench.force - vector(&given["F=-dU/dR"])).amax() < 1e-15);
    assert!((wrench.moment - vector(&given["K=-dU/dphi"])).amax() < 1e-15);
    // Turned, with the charges turned back against it: the same in the world.
    let turned = Spatial {
        position: UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -0.3, 1.1)) * state.position,
        attitude: UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -0.3, 1.1)),
        ..state
    };
    let again = body.applied(0.0, &turned, &());
    let back = turned.attitude.inverse();
    assert!((back * again.force - wrench.force).amax() < 1e-15);
    assert!((back * again.moment - wrench.moment).amax() < 1e-15);
    assert!(
        again.force.dot(&again.moment).abs() < 1e-16,
        "a central field has one line of force"
    );
    let [listed] = body.loads(0.0, &turned, &());
    assert_eq!((listed.name, listed.family), ("central", Family::Field));
    assert_eq!((listed.point, listed.force), (turned.position, again.force));
    assert_eq!(listed.moment, again.moment);
}

/// F21: K = 3 μ/R³ n × J n.
#[test]
fn gravity_gradient() {
    let input = published::SatelliteInput {
        n: Vector3::new(2.0, 1.0, 2.0) / 3.0,
    };
    let moment = published::Satellite::default().applied(0.0, &Rotation::default(), &input);
    let expected = [
        -4.648_401_653_644_315e-5,
        4.648_401_653_644_315e-5,
        2.324_200_826_822_157_6e-5,
    ];
    assert!((moment - Vector3::from(expected)).amax() < 1e-12 * 4.6e-5);
    let row = acceleration(published::Satellite::OPERATIONS);
    assert_eq!((row.div, row.sqrt), (0, 0), "{row}");
    assert!(row.mul + row.add <= 45, "{row}"); // 30 to turn n, 9 for n × J n, 6 for ω × J ω
}

proptest! {
    #[test]
    fn slopes_in_space(state in spatial(), pull in -5.0..5.0, t in 0.0..5.0) {
        let body = scenes::Craft::default();
        let input = scenes::CraftInput { pull };
        // Where a branch or a bound is passed, differences say nothing.
        let of = |r: [f64; 3]| state.position + state.attitude * Vector3::from(r);
        prop_assume!(((of([-0.5, 0.0, 0.0]) - Vector3::new(-9.0, 1.0, 0.0)).norm() - 8.0).abs() > 0.02);
        let hook = of([0.3, 0.1, -0.2]).z;
        prop_assume!((hook - 0.4).abs() > 0.02 && (hook + 3.0).abs() > 0.02);
        let slope = gradient(|x| body.potential_energy(t, &moved(&state, x), &input));
        is_slope(&flat(&body.applied(t, &state, &input)), &slope)?;
    }

    #[test]
    fn slopes_of_a_body_that_only_turns(state in rotation()) {
        let body = scenes::Needle::default();
        let slope = gradient(|[a, b, c]| {
            let turned = UnitQuaternion::from_scaled_axis(Vector3::new(a, b, c)) * state.attitude;
            body.potential_energy(0.0, &Rotation { attitude: turned, ..state }, &())
        });
        is_slope(body.applied(0.0, &state, &()).as_slice(), &slope)?;
    }

    #[test]
    fn slopes_in_the_plane(state in planar()) {
        let body = scenes::Raft::default();
        let slope = gradient(|[x, y, a]| {
            let position = state.position + Vector2::new(x, y);
            let moved = Planar { position, angle: state.angle + a, ..state };
            body.potential_energy(0.0, &moved, &())
        });
        let PlanarWrench { force, moment } = body.applied(0.0, &state, &());
        is_slope(&[force.x, force.y, moment], &slope)?;
    }

    /// About the point that is held: K_P = K + (G - P) × F; and the reaction balances the rest.
    #[test]
    fn slopes_about_a_fixed_point(state in rotation()) {
        let body = scenes::Top {};
        let slope = gradient(|[a, b, c]| {
            let turned = UnitQuaternion::from_scaled_axis(Vector3::new(a, b, c)) * state.attitude;
            body.potential_energy(0.0, &Rotation { attitude: turned, ..state }, &())
        });
        let wrench = body.applied(0.0, &state, &());
        let arm = state.attitude * Vector3::new(0.0, -0.1, 0.6);
        let about_tip = wrench.moment + arm.cross(&wrench.force);
        is_slope(about_tip.as_slice(), &slope)?;
        // The force by hand: weight, and the spring along its length.
        let rim = Vector3::new(0.5, 0.0, 1.0) + state.attitude * Vector3::new(0.3, -0.1, 0.8);
        let stretch = rim - Vector3::new(1.0, 2.0, 3.0);
        let spring = stretch.normalize() * (-12.0 * (stretch.norm() - 1.0));
        let force = spring - Vector3::z() * 19.6;
        prop_assert!((wrench.force - force).amax() < 1e-12 * 40.0);
        let acceleration = body.acceleration(0.0, &state, &());
        let reactions = body.reactions(0.0, &state, &());
        let residual = body.residual(0.0, &state, &acceleration, &reactions, &());
        prop_assert!(residual.force.norm() < 1e-11 && residual.moment.norm() < 1e-11, "{residual:?}");
    }

    #[test]
    fn slopes_about_an_axis(angle in -4.0..4.0, angular_velocity in -3.0..3.0) {
        let body = scenes::Door {};
        let state = Hinge { angle, angular_velocity };
        let [slope] = gradient(|[a]| {
            body.potential_energy(0.0, &Hinge { angle: angle + a, ..state }, &())
        });
        let wrench = body.applied(0.0, &state, &());
        let axis = Vector3::new(0.0, 0.6, 0.8);
        let turn = UnitQuaternion::from_scaled_axis(axis * angle);
        let arm = turn * Vector3::new(0.4, 0.0, 0.9);
        let about_axis = (wrench.moment + arm.cross(&wrench.force)).dot(&axis);
        is_slope(&[about_axis], &[slope])?;
        // The whole moment about G by hand: the closer pulls at the handle, the coil turns about the axis.
        let handle = turn * Vector3::new(0.8, 0.05, 1.0) - Vector3::new(1.0, 2.0, 0.5);
        let closer = handle.normalize() * (-8.0 * (handle.norm() - 0.3));
        let lever = turn * Vector3::new(0.4, 0.05, 0.1);
        let moment = lever.cross(&closer) - axis * (4.0 * (angle - 0.3));
        prop_assert!((wrench.moment - moment).amax() < 1e-11, "{} {moment}", wrench.moment);
        let gate = scenes::Gate {};
        let acceleration = gate.acceleration(0.0, &state, &());
        let reactions = gate.reactions(0.0, &state, &());
        let residual = gate.residual(0.0, &state, &acceleration, &reactions, &());
        prop_assert!(residual.force.norm() < 1e-10 && residual.moment.norm() < 1e-10, "{residual:?}");
    }

    #[test]
    fn slopes_of_bodies_that_do_not_turn(position in vectors(5.0)) {
        let bead = scenes::Bead {};
        let at = |p: Vector3<f64>| Translation { position: p, velocity: Vector3::zeros() };
        let slope = gradient(|x: [f64; 3]| {
            bead.potential_energy(0.0, &at(position + Vector3::from(x)), &())
        });
        is_slope(bead.applied(0.0, &at(position), &()).force.as_slice(), &slope)?;
        let puck = scenes::Puck {};
        let at = |p: Vector2<f64>| PlanarTranslation { position: p, velocity: Vector2::zeros() };
        let slope = gradient(|x: [f64; 2]| {
            puck.potential_energy(0.0, &at(position.xy() + Vector2::from(x)), &())
        });
        is_slope(puck.applied(0.0, &at(position.xy()), &()).force.as_slice(), &slope)?;
    }
}

/// The drift over a run falls sixteenfold with twice as many steps of a method of order four, by at least eight before
/// rounding is reached.
fn shrinks(drift: impl Fn(usize) -> f64, steps: usize, bound: f64) {
    let [coarse, fine] = [steps, 2 * steps].map(|steps| drift(steps).abs());
    assert!(fine <= bound, "drifts by {fine:e}");
    assert!(
        fine <= coarse / 8.0 || fine < 1e-11,
        "{coarse:e}, then {fine:e}"
    );
}

#[test]
fn energy_is_conserved() {
    let top = scenes::Top {};
    let start = Rotation {
        attitude: UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -0.3, 1.1)),
        angular_velocity: Vector3::new(1.5, -0.8, 2.2),
    };
    let total = |s: &Rotation| top.kinetic_energy(s) + top.potential_energy(0.0, s, &());
    // Rates to 10 rad/s at steps of 4 ms: (0.04)⁴ = 3e-6 of 50 J over a hundred.
    shrinks(
        |n| total(&cf4(&top, &start, &(), 0.0..4.0, n)) - total(&start),
        500,
        1e-6,
    );

    let door = scenes::Door {};
    let start = Hinge {
        angle: 0.5,
        angular_velocity: -1.0,
    };
    let total = |s: &Hinge| door.kinetic_energy(s) + door.potential_energy(0.0, s, &());
    shrinks(
        |n| total(&cf4(&door, &start, &(), 0.0..4.0, n)) - total(&start),
        500,
        1e-6,
    );

    let raft = scenes::Raft::default();
    let start = Planar {
        position: Vector2::new(1.0, 2.0),
        angle: 0.4,
        velocity: Vector2::new(3.0, -1.0),
        angular_velocity: 2.0,
    };
    let total = |s: &Planar| raft.kinetic_energy(s) + raft.potential_energy(0.0, s, &());
    shrinks(
        |n| total(&cf4(&raft, &start, &(), 0.0..4.0, n)) - total(&start),
        1000,
        1e-5,
    );

    let charges = published::Charges {};
    let start = Spatial {
        position: Vector3::new(1.1, -0.7, 0.9),
        angular_velocity: Vector3::new(0.5, -0.8, 1.2),
        ..Spatial::default()
    };
    let total = |s: &Spatial| charges.kinetic_energy(s) + charges.potential_energy(0.0, s, &());
    shrinks(
        |n| total(&cf4(&charges, &start, &(), 0.0..4.0, n)) - total(&start),
        500,
        1e-8,
    );
}

/// dE/dt = ∂U/∂t at fixed state: a field that changes and an input that pulls are all that is left.
#[test]
fn general_law_of_energy() {
    let body = scenes::Craft::default();
    let mut state = Spatial {
        position: Vector3::new(0.5, -1.0, 2.0),
        attitude: UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -0.3, 1.1)),
        velocity: Vector3::new(1.0, 0.5, -1.0),
        angular_velocity: Vector3::new(0.5, -0.8, 1.2),
    };
    let input = scenes::CraftInput { pull: 3.0 };
    let total = |t: f64, s: &Spatial| body.kinetic_energy(s) + body.potential_energy(t, s, &input);
    for tenth in 0..20_u32 {
        let t = f64::from(tenth) / 10.0;
        let h = 1e-3;
        let later = |h: f64| total(t + h, &cf4(&body, &state, &input, t..t + h, 4));
        let rate = (8.0 * (later(h) - later(-h)) - (later(2.0 * h) - later(-2.0 * h))) / (12.0 * h);
        // U contains -m · (0, 0, 0.3 sin 2t)
        let moment = state.attitude * Vector3::new(0.3, -0.2, 0.5);
        let expected = -0.6 * (2.0 * t).cos() * moment.z;
        // Rounding of 1e3 J over h is 1e-10; h⁴ / 30 times a fifth derivative of 1e6 is 3e-8.
        assert!(
            (rate - expected).abs() < 1e-6,
            "at {t}: {rate} is not {expected}"
        );
        state = cf4(&body, &state, &input, t..t + 0.1, 50);
    }
}

/// The file holds F13's charges as they are written above.
#[test]
fn the_charges_are_those_of_the_file() {
    let given = statement("F13/F14 F=-dU/dR, K=-dU/dphi, U=sum e_k/|r_k|, attitude identity");
    let charges = given["charges, body pts"].as_array().unwrap();
    let expected = [
        (0.3, [0.2, 0.0, 0.1]),
        (-0.5, [0.0, 0.3, -0.2]),
        (0.7, [-0.1, -0.2, 0.15]),
    ];
    for (given, (charge, point)) in charges.iter().zip(expected) {
        assert_eq!(number(&given[0]), charge);
        assert_eq!(numbers::<3>(&given[1]), point);
    }
}

/// H9: the arm of a force is that in the body, however far the other end of the spring is. By the distance from G to the other
/// end, the moment would be right to 2e-16 of that times the force: to some 1e9 of these units. Several springs of one potential
/// have an arm each.
#[test]
fn moments_do_not_see_far_distances() {
    let state = Planar {
        position: [1e9 + 3.0, 2e9 - 5.0].into(),
        angle: 0.7,
        ..Planar::default()
    };
    let input = scenes::MooredInput { k: 4.0 };
    for far in [0.0, 1e9] {
        let state = Planar {
            position: state.position + Vector2::new(far, -far),
            ..state
        };
        let applied = scenes::Moored {}.applied(0.0, &state, &input);
        let arm = nalgebra::Rotation2::new(state.angle) * Vector2::new(0.25, -0.5);
        let moment = arm.perp(&applied.force);
        let largest = arm.norm() * applied.force.norm();
        assert!((applied.moment - moment).abs() <= 8.0 * f64::EPSILON * largest);
    }

    let input = scenes::TowedInput { h: 3.0 };
    let state = Spatial {
        position: [1e9 + 3.0, 2e9 - 5.0, 1.0].into(),
        attitude: newton_euler::attitude::exp(&[0.4, -0.3, 0.2].into()),
        ..Spatial::default()
    };
    let applied = scenes::Towed::default().applied(0.0, &state, &input);
    let quay = Vector3::new(1e9, 2e9, -3e9);
    let arms = [[0.25, 0.0, 1.0], [-0.5, 0.75, 0.0]].map(Vector3::from);
    let stiffness = |length: f64| {
        [
            4.0 * (1.0 - 3.0 / length) + 16.0,
            3.0 * (1.0 - 5.0 / length) - 16.0,
        ]
    };
    let (mut moment, mut largest) = (Vector3::zeros(), 0.0);
    for (i, arm) in arms.into_iter().enumerate() {
        let arm = state.attitude * arm;
        let stretch = quay - state.position - arm;
        let force = stiffness(stretch.norm())[i] * stretch;
        moment += arm.cross(&force);
        largest += arm.norm() * force.norm();
    }
    assert!((applied.moment - moment).norm() <= 8.0 * f64::EPSILON * largest);

    let input = scenes::GuidedInput { k: 4.0 };
    let state = Translation {
        position: [3.0, -5.0, 2e9].into(),
        ..Translation::default()
    };
    let applied = scenes::Guided {}.applied(0.0, &state, &input);
    let arm = Vector3::new(0.25, -0.5, 1.0);
    let largest = arm.norm() * applied.force.norm();
    assert!((applied.moment - arm.cross(&applied.force)).norm() <= 8.0 * f64::EPSILON * largest);
}

/// Springs of one potential whose stiffnesses vanish, or cancel, or nearly: their sum divides nothing.
#[test]
fn stiffnesses_that_cancel() {
    let state = Spatial {
        position: [0.3, -0.2, 0.1].into(),
        attitude: newton_euler::attitude::exp(&[0.4, -0.3, 0.2].into()),
        ..Spatial::default()
    };
    let wall = Vector3::new(3.0, 2.0, -1.0);
    for (k, h) in [(0.0, 0.0), (2.0, -2.0), (1.0, -1.0 + 1e-13), (1.5, 0.0)] {
        let braced = scenes::Braced::new(scenes::BracedParams { k, h }).unwrap();
        let arms = [Vector3::new(0.5, 0.0, 0.25), Vector3::new(0.0, -0.5, 0.0)];
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for (stiffness, arm) in [k, h].into_iter().zip(arms) {
            let arm = state.attitude * arm;
            let pull = stiffness * (wall - state.position - arm);
            force += pull;
            moment += arm.cross(&pull);
        }
        let applied = braced.applied(0.0, &state, &());
        assert!((applied.force - force).norm() < 1e-14, "{k}, {h}");
        assert!((applied.moment - moment).norm() < 1e-14, "{k}, {h}");
    }
}
