//! Changing mass and inertia, compared with closed forms and laws written by hand.

#[path = "../systems/balances.rs"]
mod balances;
#[allow(dead_code, reason = "not every joint is here")]
#[path = "../systems/compare.rs"]
mod compare;
mod linkages;
#[allow(dead_code, reason = "not every load is here")]
#[path = "../systems/oracle.rs"]
mod oracle;
mod systems;

use nalgebra::Vector3;
use newton_euler::ensemble::Ensemble;
use newton_euler::integrate::{Classical4, DormandPrince, Fixed, IntegrationError};
use newton_euler::prelude::*;

rigid_body!(Rocket::<T> {
    motion: translation,
    params: [dry = 20[kg], exhaust = 2500[m / s], flow = 1.5[kg / s]],
    states: [fuel[kg]],
    rates: [fuel = -flow],
    mass: dry + fuel,
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [thrust = world(0, 0, flow * exhaust)],
    outputs: [energy, momentum, taylor, linearization, balance],
});

fn full() -> RocketState<f64> {
    RocketState {
        motion: Translation::default(),
        fuel: 30.0,
    }
}

/// Tsiolkovsky: velocity and height over time, with the weight.
fn tsiolkovsky(t: f64) -> [f64; 2] {
    let (start, exhaust, flow) = (50.0_f64, 2500.0_f64, 1.5_f64);
    let mass = start - flow * t;
    let velocity = exhaust * (start / mass).ln() - 9.81 * t;
    let burnt = exhaust * (t - mass / flow * (start / mass).ln());
    [velocity, burnt - 0.5 * 9.81 * t * t]
}

#[test]
fn tsiolkovsky_of_every_method() {
    let rocket = Rocket::<f64>::default();
    let [velocity, height] = tsiolkovsky(20.0);
    let series = rocket.integrate(&full()).tolerance(1e-14).to(20.0).unwrap();
    let steps = rocket
        .integrate(&full())
        .method(DormandPrince { tolerance: 1e-14 });
    for end in [series, steps.to(20.0).unwrap()] {
        assert!((end.motion.velocity.z / velocity - 1.0).abs() < 1e-12);
        assert!((end.motion.position.z / height - 1.0).abs() < 1e-12);
        assert!(end.fuel.abs() < 1e-12);
    }
}

/// Of the body that is there at the moment.
#[test]
fn energy_and_momentum() {
    let rocket = Rocket::<f64>::default();
    let mut state = full();
    (state.fuel, state.motion.velocity.z, state.motion.position.z) = (7.0, 12.0, 30.0);
    assert!((rocket.kinetic_energy(&state) - 0.5 * 27.0 * 144.0).abs() < 1e-11);
    assert!((rocket.potential_energy(0.0, &state, &()) - 27.0 * 9.81 * 30.0).abs() < 1e-10);
    assert!((rocket.linear_momentum(&state).z - 27.0 * 12.0).abs() < 1e-12);
    let by_fuel = rocket.linearize(0.0, &state, &()).a()[(5, 6)];
    assert!((by_fuel + 3750.0 / (27.0 * 27.0)).abs() < 1e-14);
}

fn burn_out<S>(error: &IntegrationError<S>, time: f64) {
    assert!(
        matches!(
            error,
            IntegrationError::InvalidBody {
                invalid: InvalidBody::Mass { .. },
                ..
            }
        ),
        "{}",
        error.time()
    );
    assert!((error.time() - time).abs() < 0.02, "{}", error.time());
}

/// Nothing is left after 50 kg / 1.5 kg/s: integration ends there, by every method, in lanes too.
#[test]
fn mass_runs_out() {
    let rocket = Rocket::<f64>::default();
    let out = 50.0 / 1.5;
    let fixed = Fixed {
        method: Classical4,
        step: 0.01,
    };
    burn_out(&rocket.integrate(&full()).to(60.0).unwrap_err(), out);
    burn_out(
        &rocket
            .integrate(&full())
            .method(fixed)
            .to(60.0)
            .unwrap_err(),
        out,
    );
    burn_out(
        &rocket
            .integrate(&full())
            .method(DormandPrince { tolerance: 1e-9 })
            .to(60.0)
            .unwrap_err(),
        out,
    );
    let empty = RocketState {
        fuel: -20.5,
        ..full()
    };
    burn_out(&rocket.integrate(&empty).to(1.0).unwrap_err(), 0.0);
    let mut members = Ensemble::new(
        &rocket,
        [
            full(),
            RocketState {
                fuel: 300.0,
                ..full()
            },
        ],
    );
    assert!(members.integrate().method(fixed).to(40.0).is_err());
}

rigid_body!(Spinner {
    motion: spatial,
    states: [fuel[kg]],
    rates: [fuel = -0.2[kg / s]],
    inertia: compose([
        cuboid(0.4, 0.5, 0.9).mass(30[kg]),
        point(fuel / 2).at((0.3, 0, 0)),
        point(fuel / 2).at((-0.3, 0, 0)),
        sphere(0.1).mass(2[kg] + 0.1[kg / s] * t),
    ]),
    params: [torque = 0.3[N * m]],
    moments: [motor = body(torque, -0.1[N * m], 2 * torque)],
    outputs: [balance],
});

/// Euler's equations with the moments of inertia of the moment.
#[test]
fn a_body_of_parts() {
    let body = Spinner::default();
    let state = SpinnerState {
        motion: Spatial {
            angular_velocity: Vector3::new(0.4, -1.2, 0.7),
            ..Spatial::default()
        },
        fuel: 5.0,
    };
    let sphere = 0.4 * (2.0 + 0.1 * 3.0) * 0.01;
    let box_of = |a: f64, b: f64| 30.0 / 12.0 * (a * a + b * b) + sphere;
    let tanks = 5.0 * 0.09;
    let j = Vector3::new(
        box_of(0.5, 0.9),
        box_of(0.4, 0.9) + tanks,
        box_of(0.4, 0.5) + tanks,
    );
    let w = state.motion.angular_velocity;
    let moment = Vector3::new(0.3, -0.1, 0.6) - w.cross(&j.component_mul(&w));
    let found = body.acceleration(3.0, &state, &()).motion.angular;
    assert!((found - moment.component_div(&j)).norm() < 1e-14);
}

rigid_body!(Skater {
    motion: planar,
    mass: 60[kg],
    states: [arms[m]],
    rates: [arms = -0.2[m / s]],
    inertia: 1.2[kg * m ^ 2] + 4[kg] * arms.powi(2) * (arms / arms.abs()),
    moments: [drawn_in = -(2 * 4[kg] * arms * -0.2[m / s]) * angular_velocity],
});

/// With the moment that drawing in the arms makes, her angular momentum is kept; and where there is no such
/// body, the motion ends.
#[test]
fn a_skater() {
    let skater = Skater::default();
    let start = SkaterState {
        motion: Planar {
            angular_velocity: 2.0,
            ..Planar::default()
        },
        arms: 0.8,
    };
    let end = skater.integrate(&start).tolerance(1e-13).to(3.0).unwrap();
    let inertia = |arms: f64| 1.2 + 4.0 * arms * arms;
    let kept = 2.0 * inertia(0.8) / inertia(0.2);
    assert!((end.motion.angular_velocity / kept - 1.0).abs() < 1e-11);
    let error = skater.integrate(&start).to(20.0).unwrap_err();
    assert!(
        matches!(
            error,
            IntegrationError::InvalidBody {
                invalid: InvalidBody::PlanarInertia { .. },
                ..
            }
        ),
        "{error}"
    );
}
