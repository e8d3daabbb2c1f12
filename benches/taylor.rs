//! Steps of the Taylor integrator: the time of a step by order, and the time of a simulated second
//! by tolerance.
//!
//! Times are the shortest of a few runs, in one thread. The error is that of attitude and relative
//! angular velocity after 10 s, compared with the 40-digit trajectories of `tests/reference`. Run
//! `cargo bench --bench taylor`.
//!
//! `cargo bench --bench taylor -- long` takes 10⁸ compensated steps of order 16 instead, which are
//! 12.5 million seconds of the free body, and prints the errors of energy and angular momentum.

use std::hint::black_box;
use std::time::Instant;

use newton_euler::integrate::{self, Motion};
use newton_euler::prelude::*;
use serde_json::Value;

#[path = "../tests/reference/mod.rs"]
mod reference;
use reference::{distance, trajectory, vector};

rigid_body!(AsymmetricFree {
    motion: rotation,
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
    outputs: [taylor, energy, momentum],
});

rigid_body!(HeavyAsym {
    motion: rotation,
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
    moments: [weight = body(0, 0, 1).cross(world(0, 0, -1))],
    outputs: [taylor],
});

rigid_body!(LagrangeTop {
    motion: rotation,
    inertia: principal(1, 1, 0.5)[kg * m ^ 2],
    moments: [weight = body(0, 0, 1).cross(world(0, 0, -5))],
    outputs: [taylor],
});

// the same body with moments that are equal only at run time, so that its series use its own axes
rigid_body!(HiddenTop {
    motion: rotation,
    params: [across = 1[kg * m ^ 2], again = 1[kg * m ^ 2]],
    inertia: principal(across, again, 0.5[kg * m ^ 2]),
    moments: [weight = body(0, 0, 1).cross(world(0, 0, -5))],
    outputs: [taylor],
});

/// The start of a problem, and its state after 10 s.
fn ends(name: &str) -> [Rotation; 2] {
    let problem = trajectory(name);
    let [early, whole] = [&problem["at_T_10"], &problem];
    let end = if early.is_null() { whole } else { early };
    let state = |attitude: &Value, rates: &Value| Rotation {
        attitude: reference::attitude(attitude),
        angular_velocity: vector(rates),
    };
    [
        state(&problem["q0"], &problem["w0"]),
        state(&end["q_ref"], &end["w_ref"]),
    ]
}

/// The shortest time of a few runs \[s\].
fn least(mut run: impl FnMut()) -> f64 {
    let once = |run: &mut dyn FnMut()| {
        let start = Instant::now();
        run();
        start.elapsed().as_secs_f64()
    };
    (0..15)
        .map(|_| once(&mut run))
        .fold(f64::INFINITY, f64::min)
}

fn step<B: Taylor<State = Rotation, Input = ()>, const N: usize>(body: &B, start: &Rotation) {
    const STEPS: u32 = 4000;
    let time = least(|| {
        let mut motion = Motion::<B, N>::new(body, 0.0, black_box(start));
        for _ in 0..STEPS {
            motion.step(0.01, &()).expect("finite");
        }
        black_box(motion.state());
    });
    print!("  {:>2}: {:4.0}", N - 1, time / f64::from(STEPS) * 1e9);
}

fn problem<B: Taylor<State = Rotation, Input = ()>>(name: &str, note: &str, body: &B) {
    let [start, expected] = ends(name);
    println!("{name}{note}");
    print!("  ns of a step by order:");
    step::<B, 9>(body, &start);
    step::<B, 13>(body, &start);
    step::<B, 17>(body, &start);
    step::<B, 21>(body, &start);
    step::<B, 25>(body, &start);
    println!();
    let w = expected.angular_velocity;
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-12, 1e-15] {
        let end = || integrate::taylor(body, black_box(&start), &(), 0.0..10.0, tolerance);
        let time = least(|| {
            black_box(end()).expect("finite");
        });
        let end = end().expect("finite");
        let rates = (end.angular_velocity - w).norm() / w.norm();
        let error = distance(&end.attitude, &expected.attitude).max(rates);
        println!(
            "  tolerance {tolerance:e}: {:5.0} ns of a simulated second, error {error:.1e}",
            time * 1e8
        );
    }
}

fn long() {
    let (body, [start, _]) = (AsymmetricFree::default(), ends("asymmetric_free"));
    let (energy, momentum) = (body.kinetic_energy(&start), body.angular_momentum(&start));
    let begin = Instant::now();
    let mut motion = Motion::<_, 17>::new(&body, 0.0, &start);
    let mut taken = 0;
    for steps in [1_000_000, 10_000_000, 100_000_000] {
        for _ in taken..steps {
            motion.step(0.125, &()).expect("finite");
        }
        taken = steps;
        let end = motion.state();
        let now = body.angular_momentum(&end);
        println!(
            "{steps} steps, {:.0} ns each: relative change of energy {:.1e}, of angular momentum {:.1e}, of its length {:.1e}",
            begin.elapsed().as_secs_f64() / f64::from(steps) * 1e9,
            body.kinetic_energy(&end) / energy - 1.0,
            (now - momentum).norm() / momentum.norm(),
            now.norm() / momentum.norm() - 1.0,
        );
    }
}

fn main() {
    if std::env::args().any(|argument| argument == "long") {
        return long();
    }
    problem("asymmetric_free", "", &AsymmetricFree::default());
    problem("heavy_asym", "", &HeavyAsym::default());
    problem("lagrange_nutation", "", &LagrangeTop::default());
    let hidden = HiddenTop::default();
    problem("lagrange_nutation", " in axes that spin", &hidden);
}
