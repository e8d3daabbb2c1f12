//! What a motion about a support conserves, and the laws of momentum with the reactions of the
//! support.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::{integrate::cf4, prelude::*};

mod scenes {
    use newton_euler::rigid_body;

    rigid_body!(Pendulum {
        motion: pivot(pin).at(world(0.5, -1)),
        mass: 2.5,
        inertia: 0.8,
        points: [pin = (0.3, -0.4)],
        pole: pin,
        fields: [
            weight = mass * world(0, -9.80665),
            electric = world(3, -2).at((-0.7, 0.2))
        ],
        reactions: [hold = world(_, _).at(pin)],
        outputs: [energy, momentum, reactions, balance],
    });

    rigid_body!(Top {
        motion: fixed_point(tip).at(world(0.5, -1, 2)),
        inputs: [weight],
        mass: 2.5,
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: -0.12,
            yz: -0.05,
            zx: 0.07
        },
        points: [tip = (0.3, -0.4, -0.6)],
        pole: tip,
        forces: [pull = weight * world(0, 0, -1)],
        reactions: [hold = world(_, _, _).at(tip)],
        outputs: [energy, momentum, reactions, balance],
    });

    rigid_body!(Gate {
        motion: fixed_axis(lower, body(1, -2, 2)).at(world(0.5, -1, 2)),
        mass: 2.5,
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: -0.12,
            yz: -0.05,
            zx: 0.07
        },
        points: [lower = (0.3, -0.4, -0.6), upper = (0.6, -1, 0)],
        pole: upper,
        fields: [weight = mass * world(0, 0, -9.80665)],
        reactions: [
            hold = body(_, _, _).at(lower),
            slide = body(_, _, 0).at(upper)
        ],
        outputs: [energy, momentum, reactions, balance],
    });
}

const PULL: scenes::TopInput = scenes::TopInput {
    weight: 2.5 * 9.80665,
};
const FREE: scenes::TopInput = scenes::TopInput { weight: 0.0 };

fn swinging() -> Hinge {
    Hinge {
        angle: 0.4,
        angular_velocity: 3.0,
    }
}

fn spinning() -> Rotation {
    Rotation {
        attitude: UnitQuaternion::from_scaled_axis(Vector3::new(0.2, -0.7, 0.3)),
        angular_velocity: Vector3::new(0.5, -1.5, 4.0),
    }
}

/// The method has order four, so that twice the steps leave a sixteenth of the drift; terms of the next order may make
/// it a tenth.
fn shrinks(drift: impl Fn(usize) -> f64, steps: usize, bound: f64) {
    let (coarse, fine) = (drift(steps).abs(), drift(2 * steps).abs());
    assert!(fine <= bound, "drifts by {fine:e}");
    assert!(coarse >= 10.0 * fine, "{coarse:e} becomes {fine:e}");
}

#[test]
fn energy() {
    let pendulum = scenes::Pendulum::default();
    let total =
        |state: &Hinge| pendulum.kinetic_energy(state) + pendulum.potential_energy(0.0, state, &());
    let drift =
        |steps| total(&cf4(&pendulum, &swinging(), &(), 0.0..5.0, steps)) - total(&swinging());
    shrinks(drift, 500, 1e-6);

    let gate = scenes::Gate::default();
    let total = |state: &Hinge| gate.kinetic_energy(state) + gate.potential_energy(0.0, state, &());
    let drift = |steps| total(&cf4(&gate, &swinging(), &(), 0.0..5.0, steps)) - total(&swinging());
    shrinks(drift, 500, 1e-6);

    let top = scenes::Top::default();
    let height = |state: &Rotation| (state.attitude * Vector3::new(-0.3, 0.4, 0.6)).z;
    let total = |state: &Rotation| top.kinetic_energy(state) + PULL.weight * height(state);
    let drift = |steps| total(&cf4(&top, &spinning(), &PULL, 0.0..5.0, steps)) - total(&spinning());
    shrinks(drift, 1000, 1e-6);
}

/// About the point that is held: all of it without loads, its vertical component with weight.
#[test]
fn angular_momentum_about_the_support() {
    let top = scenes::Top::default();
    let about = |state: &Rotation| top.angular_momentum_about_pole(0.0, state);
    let drift = |input, steps| {
        let end = cf4(&top, &spinning(), input, 0.0..5.0, steps);
        about(&end) - about(&spinning())
    };
    shrinks(|steps| drift(&FREE, steps).norm(), 1000, 1e-6);
    shrinks(|steps| drift(&PULL, steps).z, 1000, 1e-6);
    assert!(drift(&PULL, 1000).norm() > 1.0);
    // but about G it changes even then
    let end = cf4(&top, &spinning(), &FREE, 0.0..5.0, 1000);
    assert!((top.angular_momentum(&end) - top.angular_momentum(&spinning())).norm() > 1.0);
}

/// `dP/dt` is the sum of the forces and `dL_O/dt = M_O - v_O × P`, both with the reactions.
#[test]
fn rates_of_the_momenta() {
    // a difference over 2 h errs by h²/6 of third derivatives, to 1e4 here: 2e-7; and by roundings over h
    let h = 1e-5;
    let bound = 1e-6;

    let pendulum = scenes::Pendulum::default();
    let mut state = swinging();
    for _ in 0..20 {
        state = cf4(&pendulum, &state, &(), 0.0..0.1, 20);
        let [before, after] = [-h, h].map(|h| cf4(&pendulum, &state, &(), 0.0..h, 1));
        let rate =
            (pendulum.linear_momentum(&after) - pendulum.linear_momentum(&before)) / (2.0 * h);
        let applied = pendulum.applied(0.0, &state, &());
        let hold = pendulum.reactions(0.0, &state, &()).hold;
        assert!((rate - applied.force - hold).amax() < bound);
        // the pole is the pin, which rests
        let about = |state| pendulum.angular_momentum_about_pole(0.0, state);
        let rate = (about(&after) - about(&before)) / (2.0 * h);
        let from_pin = pendulum.linear_momentum(&state) / 2.5 / state.angular_velocity;
        // v = ω × c: c is the velocity turned back, over ω
        let center = nalgebra::Vector2::new(from_pin.y, -from_pin.x);
        let moment = applied.moment + center.perp(&applied.force);
        assert!((rate - moment).abs() < bound, "{rate} is not {moment}");
    }

    let gate = scenes::Gate::default();
    let mut state = swinging();
    for _ in 0..20 {
        state = cf4(&gate, &state, &(), 0.0..0.1, 20);
        let [before, after] = [-h, h].map(|h| cf4(&gate, &state, &(), 0.0..h, 1));
        let rate = (gate.linear_momentum(&after) - gate.linear_momentum(&before)) / (2.0 * h);
        let applied = gate.applied(0.0, &state, &());
        let scenes::GateReactions { hold, slide } = gate.reactions(0.0, &state, &());
        assert!((rate - applied.force - hold - slide).amax() < bound);
        // the pole is the upper bearing, which rests; there its load has no moment
        let about = |state| gate.angular_momentum_about_pole(0.0, state);
        let rate = (about(&after) - about(&before)) / (2.0 * h);
        let axis = Vector3::new(1.0, -2.0, 2.0) / 3.0;
        let to_world = UnitQuaternion::from_scaled_axis(axis * state.angle);
        let upper = Vector3::new(0.6, -1.0, 0.0);
        let lower = Vector3::new(0.3, -0.4, -0.6);
        let moment = applied.moment
            + (to_world * -upper).cross(&applied.force)
            + (to_world * (lower - upper)).cross(&hold);
        assert!((rate - moment).amax() < bound, "{rate} is not {moment}");
    }
}
