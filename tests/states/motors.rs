//! Motors that lag, and the fuel that they use, with every method, compared with the first-order
//! response in closed form.

use newton_euler::integrate::{
    Classical4, DormandPrince, DormandPrince8, Fixed, Midpoint, RungeKutta, TaylorSeries,
    Tsitouras5, Verner9, cf4,
};
use newton_euler::prelude::*;

use crate::bodies::{
    Arms, ArmsInput, ArmsState, Drone, DroneInput, DroneState, Filter, FilterState, Rocket,
    RocketInput, RocketState,
};
use crate::distance;

const COMMAND: RocketInput = RocketInput { command: 6.0 };

/// ```text
/// thrust = c + (f0 - c) e,    e = exp(-t / T)
/// fuel   = m0 - b (c t + (f0 - c) T (1 - e))
/// m v    = c t + (f0 - c) T (1 - e)
/// m x    = c t^2 / 2 + (f0 - c) T (t - T (1 - e))
/// ```
fn closed_form(start: &RocketState, t: f64) -> RocketState {
    let (lag, flow, mass, command) = (0.05, 0.25, 2.0, COMMAND.command);
    let lack = start.thrust - command;
    let gone = lag * -(-t / lag).exp_m1();
    let momentum = command * t + lack * gone;
    let path = command * t * t / 2.0 + lack * lag * (t - gone);
    let mut end = *start;
    end.thrust = command + lack * (-t / lag).exp();
    end.fuel = start.fuel - flow * momentum;
    end.motion.velocity.z += momentum / mass;
    end.motion.position.z += start.motion.velocity.z * t + path / mass;
    end
}

fn starts() -> RocketState {
    RocketState {
        motion: Translation {
            velocity: [0.0, 0.0, -0.5].into(),
            ..Translation::default()
        },
        thrust: 1.5,
        fuel: 3.0,
    }
}

#[test]
fn a_motor_lags() {
    let (rocket, start) = (Rocket::default(), starts());
    let motion = || rocket.integrate(&start).input(COMMAND);
    let samples = motion().tolerance(1e-14).samples(0.7, 0.05);
    for sample in samples.map(Result::unwrap) {
        let error = distance(&sample.state, &closed_form(&start, sample.time));
        assert!(error < 1e-12, "series at {}: {error:e}", sample.time);
    }
    let expected = closed_form(&start, 0.7);
    let method = DormandPrince { tolerance: 1e-14 };
    let error = distance(&motion().method(method).to(0.7).unwrap(), &expected);
    assert!(error < 1e-12, "{error:e}");
    // and back
    let back = rocket.integrate(&expected).input(COMMAND).starting_at(0.7);
    let error = distance(&back.tolerance(1e-14).to(0.0).unwrap(), &start);
    assert!(error < 1e-7, "{error:e}");
}

/// Tolerances count states of one's own: where nothing but these changes fast, they rule the steps.
#[test]
fn tolerances_count_them() {
    let start = starts();
    let rocket = Rocket::default();
    let expected = closed_form(&start, 0.7);
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
        let motion = || rocket.integrate(&start).input(COMMAND);
        let series = motion().method(TaylorSeries { tolerance }).to(0.7).unwrap();
        let steps = motion()
            .method(DormandPrince { tolerance })
            .to(0.7)
            .unwrap();
        for end in [series, steps] {
            let error = (end.thrust - expected.thrust).abs();
            assert!(error < 100.0 * tolerance, "{tolerance:e}: {error:e}");
        }
    }
}

fn in_equal_steps<M: RungeKutta>(method: M, step: f64) {
    let (rocket, start) = (Rocket::default(), starts());
    let expected = closed_form(&start, 0.5);
    let error = |step| {
        let motion = rocket.integrate(&start).input(COMMAND);
        let end = motion.method(Fixed { method, step }).to(0.5).unwrap();
        distance(&end, &expected)
    };
    let [coarse, fine] = [error(step), error(step / 2.0)];
    #[expect(clippy::cast_precision_loss, reason = "small")]
    let least = M::ORDER as f64 - 0.5;
    let order = (coarse / fine).log2();
    assert!(order > least, "{method:?}: {coarse:e}, {fine:e}");
}

#[test]
fn by_every_method() {
    in_equal_steps(Midpoint, 0.005);
    in_equal_steps(Classical4, 0.01);
    in_equal_steps(Tsitouras5, 0.01);
    in_equal_steps(DormandPrince8, 0.05);
    in_equal_steps(Verner9, 0.05);
    let (rocket, start) = (Rocket::default(), starts());
    let expected = closed_form(&start, 0.5);
    let error = |steps| distance(&cf4(&rocket, &start, &COMMAND, 0.0..0.5, steps), &expected);
    let [coarse, fine] = [100, 200].map(error);
    assert!((coarse / fine).log2() > 3.5, "{coarse:e}, {fine:e}");
}

/// When the fuel runs out is an event, and what an event changes is a plain field.
#[test]
fn events_see_them() {
    let (rocket, start) = (Rocket::default(), starts());
    let motion = rocket.integrate(&start).input(COMMAND).tolerance(1e-13);
    let mut empty = motion.events(100.0, |_, state: &RocketState| state.fuel - 1.0);
    let event = empty.next().expect("the fuel runs low").unwrap();
    let expected = closed_form(&start, event.time);
    assert!((expected.fuel - 1.0).abs() < 1e-11);
    let mut off = event.state;
    off.thrust = 0.0;
    let off = rocket.integrate(&off).starting_at(event.time);
    let coasting = off.to(event.time + 1.0).unwrap();
    assert_eq!((coasting.thrust, coasting.fuel), (0.0, event.state.fuel));
    assert_eq!(coasting.motion.velocity, event.state.motion.velocity);
}

/// A drone that turns, along series and in steps; its accelerations are those of a body of which
/// the speeds are inputs.
#[test]
fn series_beside_steps() {
    let drone = Drone::default();
    let start = DroneState {
        motion: Spatial {
            velocity: [0.3, -0.2, 0.4].into(),
            angular_velocity: [0.5, 0.7, -1.1].into(),
            ..Spatial::default()
        },
        speed_1: 310.0,
        speed_2: 290.0,
    };
    let input = DroneInput {
        command_1: 325.0,
        command_2: 319.0,
    };
    let motion = || drone.integrate(&start).input(input);
    let series = motion().tolerance(1e-14).to(2.0).unwrap();
    let method = DormandPrince { tolerance: 1e-15 };
    let error = distance(&series, &motion().method(method).to(2.0).unwrap());
    // of speeds of 300 rad / s
    assert!(error < 3e-11, "{error:e}");
    let residual = drone.residual(
        0.0,
        &start,
        &drone.acceleration(0.0, &start, &input),
        &(),
        &input,
    );
    assert!(residual.force.norm() < 1e-13 && residual.moment.norm() < 1e-14);
    let rate = drone.acceleration(0.0, &start, &input);
    let climb = (start.motion.attitude.inverse() * start.motion.velocity).z;
    let expected = (325.0 - 310.0) / 0.08 - 0.1 * climb;
    assert!((rate.speed_1 - expected).abs() < 1e-12);
}

/// Each motor of two follows its own response; the work that both do is the energy gained.
#[test]
fn two_motors() {
    let arms = Arms::default();
    let start = ArmsState::default();
    let input = ArmsInput {
        command_1: 3.0,
        command_2: -1.5,
    };
    let energy = |state: &ArmsState<f64>| {
        arms.kinetic_energy(state) + arms.potential_energy(0.0, state, &input)
    };
    let motion = arms.integrate(&start).input(input).tolerance(1e-14);
    for sample in motion.samples(1.0, 0.1).map(Result::unwrap) {
        let (state, t) = (sample.state, sample.time);
        assert!((state.torque_1 - 3.0 * -(-t / 0.05).exp_m1()).abs() < 1e-12);
        assert!((state.torque_2 + 1.5 * -(-t / 0.03).exp_m1()).abs() < 1e-12);
        let gained = energy(&state) - energy(&start);
        assert!((state.work - gained).abs() < 1e-12, "{t}: {gained}");
    }
    let matrix = arms.mass_matrix(0.0, &start, &input);
    assert_eq!(matrix.shape(), (2, 2));
}

/// Without a joint that moves, what moves are these alone: a harmonic oscillation here.
#[test]
fn of_a_system_at_rest() {
    let filter = Filter::default();
    let start = FilterState {
        force: 2.0,
        rate: 0.0,
    };
    let ends = [
        filter.integrate(&start).tolerance(1e-14).to(1.0).unwrap(),
        filter
            .integrate(&start)
            .method(DormandPrince { tolerance: 1e-14 })
            .to(1.0)
            .unwrap(),
    ];
    for end in ends {
        assert!((end.force - 2.0 * 3.0_f64.cos()).abs() < 1e-12);
        assert!((end.rate + 6.0 * 3.0_f64.sin()).abs() < 1e-12);
        let moment = filter.reactions(1.0, &end, &()).base.moment;
        assert!((moment + 0.2 * end.force).abs() < 1e-12, "{moment}");
    }
}
