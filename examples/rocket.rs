//! A rocket that burns its fuel: mass and inertia depend on the fuel, a user-defined state.
//!
//! Body z is along the rocket, with G in the middle of the tank, so that it stays fixed. The jet
//! damps rotation: exhaust leaves with the velocity of the nozzle, and carries away its moment of
//! momentum (the moment `-flow l^2 w` of jet damping, and the moment `-J' w` for the share of the
//! fuel in the tank).
//!
//! Asserts: velocity and height are those of Tsiolkovsky; the events of burnout and apogee are at
//! the times in closed form; the remaining rotation rate is a power of the mass ratio.

use newton_euler::nalgebra::Vector3;
use newton_euler::prelude::*;

rigid_body!(Rocket {
    doc: "A rocket that burns its fuel.",
    motion: spatial,
    params: [
        dry = 20[kg],
        exhaust = 2500[m / s],
        flow = 1.5[kg / s],
        nozzle = 1.5[m],
        gyration = 0.8[m],
    ],
    states: [fuel[kg]],
    rates: [fuel = -flow],
    mass: dry + fuel,
    inertia: principal(
        mass * gyration.powi(2),
        mass * gyration.powi(2),
        mass * 0.01[m ^ 2]
    ),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [thrust = body(0, 0, flow * exhaust)],
    locals: [w = angular_velocity.in_body()],
    moments: [jet_damping = flow * (gyration.powi(2) - nozzle.powi(2)) * body(w.x, w.y, 0)],
    outputs: [energy, momentum],
});

/// Height and time of the apogee: up to burnout, and on without thrust.
fn coast(rocket: &Rocket, start: &RocketState) -> (f64, f64) {
    let mut empty = (rocket.integrate(start)).events(30.0, |_, rocket| rocket.fuel);
    let burnout = empty.next().expect("it burns out").expect("it flies");
    assert!((burnout.time - 30.0 / 1.5).abs() < 1e-9);
    let params = RocketParams {
        flow: 0.0,
        ..*rocket.params()
    };
    let coasting = Rocket::new(params).expect("a possible body");
    let motion = (coasting.integrate(&burnout.state)).starting_at(burnout.time);
    let mut level = motion.events(1000.0, |_, rocket| rocket.motion.velocity.z);
    let apogee = level.next().expect("it falls").expect("it flies");
    let known = burnout.time + burnout.state.motion.velocity.z / 9.80665;
    assert!((apogee.time - known).abs() < 1e-6);
    (apogee.state.motion.position.z, apogee.time)
}

fn main() {
    let rocket = Rocket::default();
    let start = RocketState {
        motion: Spatial::default(),
        fuel: 30.0,
    };
    println!("{}\n", Rocket::EQUATIONS);
    println!("  t/s   fuel/kg   v/(m/s)      height/m      off Tsiolkovsky: v/(m/s), height/m");
    for time in [5.0, 10.0, 15.0, 20.0] {
        let end = rocket.integrate(&start).to(time).expect("there is fuel");
        let ratio = (50.0_f64 / (50.0 - 1.5 * time)).ln();
        let velocity = 2500.0 * ratio - 9.80665 * time;
        let burnt = 2500.0 * (time - (50.0 - 1.5 * time) / 1.5 * ratio);
        let height = burnt - 0.5 * 9.80665 * time * time;
        let [v, z] = [end.motion.velocity.z, end.motion.position.z];
        println!(
            "  {time:4.1}  {:7.3}  {v:11.6}  {z:12.6}   {:+.1e}  {:+.1e}",
            end.fuel,
            v - velocity,
            z - height
        );
        assert!((v - velocity).abs() < 1e-6 && (z - height).abs() < 1e-5);
    }
    let apogee = coast(&rocket, &start);
    println!("apogee {:.3} m, after {:.3} s", apogee.0, apogee.1);

    let turning = RocketState {
        motion: Spatial {
            angular_velocity: Vector3::new(0.01, 0.0, 0.0),
            ..Spatial::default()
        },
        ..start
    };
    let end = rocket.integrate(&turning).to(20.0).expect("there is fuel");
    // (J w)' = -flow l^2 w and J = m k^2: w goes with m^(l^2 / k^2 - 1)
    let left = 0.01 * 0.4_f64.powf(1.5 * 1.5 / (0.8 * 0.8) - 1.0);
    println!(
        "\nof a turn of 0.01 rad/s jet damping leaves {:.9} rad/s, the closed form {left:.9}",
        end.motion.angular_velocity.x
    );
    assert!((end.motion.angular_velocity.x - left).abs() < 1e-9);
    let ended = rocket.integrate(&start).to(60.0).expect_err("it runs out");
    println!("{ended}");
}
