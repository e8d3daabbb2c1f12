//! A rod on a pin: its period, the point where a blow causes no force on the pin, and the force of
//! the pin.
//!
//! Asserts, all in closed form for a uniform rod of length L on a pin at its end: released level,
//! the pin carries a quarter of the weight, and five halves of it as the rod passes its lowest
//! position; the period from the arithmetic-geometric mean; the same period from a pin at the
//! center of oscillation, 2 L / 3 below (Kater's reversible pendulum); and no pin force along a
//! blow on that point (center of percussion).

use std::f64::consts::{FRAC_PI_2, PI};

use newton_euler::{integrate, prelude::*};

const G: f64 = 9.80665;

rigid_body!(Pendulum {
    doc: "A uniform rod on a pin above its center, and a horizontal blow below the pin; y along the rod, up at rest.",
    motion: pivot(pin),
    params: [
        weight_of_rod = 2[kg],
        length = 1.2[m],
        hung = 0.6[m],
        struck = 0.8[m]
    ],
    inputs: [blow[N]],
    mass: weight_of_rod,
    inertia: mass * length.powi(2) / 12,
    points: [pin = (0, hung), target = (0, hung - struck)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [hit = world(blow, 0).at(target)],
    reactions: [hold = world(_, _).at(pin)],
    outputs: [energy, reactions],
});

/// Twice the time from one end of a swing to the other.
fn measured_period(pendulum: &Pendulum, amplitude: f64) -> f64 {
    let none = PendulumInput::default();
    let (mut state, mut time, step) = (at_rest(amplitude), 0.0, 1e-4);
    loop {
        let next = integrate::cf4_step(pendulum, time, &state, &none, step);
        if next.angular_velocity >= 0.0 && time > 0.0 {
            // it comes to rest within this step: Newton's method
            let mut ahead = 0.0;
            for _ in 0..4 {
                let there = integrate::cf4_step(pendulum, time, &state, &none, ahead);
                ahead -= there.angular_velocity / pendulum.acceleration(time, &there, &none);
            }
            return 2.0 * (time + ahead);
        }
        (state, time) = (next, time + step);
    }
}

/// `2 π / ω₀ / agm(1, cos(amplitude / 2))`, with `ω₀² = m g d / J_O`.
fn period(length: f64, hung: f64, amplitude: f64) -> f64 {
    let reduced = (length.powi(2) / 12.0 + hung.powi(2)) / hung;
    let (mut mean, mut other) = (1.0, (amplitude / 2.0).cos());
    for _ in 0..6 {
        (mean, other) = (f64::midpoint(mean, other), (mean * other).sqrt());
    }
    2.0 * PI * (reduced / G).sqrt() / mean
}

fn at_rest(angle: f64) -> Hinge {
    Hinge {
        angle,
        angular_velocity: 0.0,
    }
}

fn main() {
    let pendulum = Pendulum::default();
    let PendulumParams {
        weight_of_rod,
        length,
        hung,
        ..
    } = *pendulum.params();
    let none = PendulumInput::default();

    println!("a rod of {weight_of_rod} kg and {length} m on a pin at its end, let go level");
    let level = at_rest(FRAC_PI_2);
    let force = |state: &Hinge| pendulum.reactions(0.0, state, &none).hold / (weight_of_rod * G);
    println!(
        "  pin force at first: {:.15} of the weight (1/4)",
        force(&level).y
    );
    let rate = -(3.0 * G / length).sqrt();
    let below = Hinge {
        angle: 0.0,
        angular_velocity: rate,
    };
    println!(
        "  pin force below:    {:.15} of the weight (5/2)",
        force(&below).y
    );
    let energy =
        |state| pendulum.kinetic_energy(state) + pendulum.potential_energy(0.0, state, &none);
    println!(
        "  energy gained between: {:.1e} J",
        energy(&below) - energy(&level)
    );

    println!("\namplitude/rad    period/s         in closed form   with the pin 2 L / 3 lower");
    // the same rod from its center of oscillation, which is on the other side of G
    let reversed = Pendulum::new(PendulumParams {
        hung: length / 6.0,
        ..*pendulum.params()
    })
    .expect("a rod");
    for amplitude in [0.1, 1.0, 2.0, 3.0] {
        println!(
            "    {amplitude:.1}          {:.11}    {:.11}    {:.11}",
            measured_period(&pendulum, amplitude),
            period(length, hung, amplitude),
            measured_period(&reversed, amplitude),
        );
    }

    println!("\na blow of 100 N at rest: what the pin adds to it");
    for distance in [0.5, 2.0 / 3.0, 1.0] {
        let struck_there = Pendulum::new(PendulumParams {
            struck: distance * length,
            ..*pendulum.params()
        })
        .expect("a rod");
        let hold = struck_there
            .reactions(0.0, &at_rest(0.0), &PendulumInput { blow: 100.0 })
            .hold;
        // rounded, so that a zero has no sign
        println!(
            "  at {distance:.3} L: {:9.4} N",
            (hold.x * 1e9).round() / 1e9 + 0.0
        );
    }
    println!(
        "  (100 N (3 x / 2 L - 1): -25, 0, 50)\n\n{}",
        Pendulum::EQUATIONS
    );
}
