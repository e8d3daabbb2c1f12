//! The cost of closed forms: one evaluation, with and without its setup, compared with one step of
//! an integrator on the same body.
//!
//! The shortest time of many rounds is taken, in one thread. Run `cargo bench --bench flow`.

use std::hint::black_box;
use std::time::Instant;

use newton_euler::prelude::*;
use newton_euler::{attitude, integrate};

rigid_body!(Symmetric {
    motion: rotation,
    inertia: principal(2, 2, 1),
    outputs: [flow],
});

rigid_body!(Asymmetric {
    motion: rotation,
    inertia: principal(0.6, 0.8, 1),
    outputs: [flow],
});

rigid_body!(Brick {
    motion: rotation,
    inertia: principal(10, 20, 26),
    outputs: [flow],
});

rigid_body!(Handle {
    motion: rotation,
    inertia: principal(1, 2, 3),
    outputs: [flow],
});

rigid_body!(Tilted {
    motion: spatial,
    params: [xx = 1.3],
    mass: 2[kg],
    inertia: tensor {
        xx: xx,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    },
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Top {
    motion: fixed_point(tip),
    mass: 2[kg],
    inertia: principal(0.2, 0.2, 0.1),
    points: [tip = (0, 0, -0.1[m])],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Stage {
    motion: rotation,
    inertia: principal(0.3, 0.3, 0.1),
    moments: [motor = body(0, 0, 0.2)],
    outputs: [flow],
});

rigid_body!(Clock {
    motion: pivot(pin),
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    points: [pin = (0, 0.7[m])],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

const ROUNDS: usize = 200;
const CALLS: u32 = 500;

/// The nanoseconds that a call takes, at different times of the motion.
fn least<T>(span: f64, call: impl Fn(f64) -> T) -> f64 {
    let round = || {
        let start = Instant::now();
        for k in 0..CALLS {
            black_box(call(black_box(span * f64::from(k) / f64::from(CALLS))));
        }
        start.elapsed().as_secs_f64() * 1e9 / f64::from(CALLS)
    };
    (0..ROUNDS).map(|_| round()).fold(f64::INFINITY, f64::min)
}

fn measure<B: Flow<Scalar = f64>>(what: &str, body: &B, state: &B::State, span: f64)
where
    B::State: State<Scalar = f64>,
{
    let (path, input) = (body.path(state), B::Input::default());
    let evaluation = least(span, |time| path.at(time));
    let with_set_up = least(span, |time| body.flow(black_box(state), time));
    let step = least(span, |time| {
        integrate::cf4_step(body, time, black_box(state), &input, 1e-2)
    });
    println!("{what:44}{evaluation:>14.0}{with_set_up:>14.0}{step:>14.0}");
}

fn main() {
    println!(
        "{:44}{:>14}{:>14}{:>14}",
        "ns", "evaluation", "with set-up", "step of CF4"
    );
    let spun = |rates: [f64; 3]| Rotation {
        angular_velocity: rates.into(),
        ..Rotation::default()
    };
    measure(
        "symmetric",
        &Symmetric::default(),
        &spun([0.4, 0.1, 3.0]),
        100.0,
    );
    measure(
        "asymmetric",
        &Asymmetric::default(),
        &spun([3.0, 0.5, -0.9]),
        100.0,
    );
    measure("brick", &Brick::default(), &spun([1.0, 15.0, 1.0]), 10.0);
    measure(
        "handle, a flip every 27.53 s",
        &Handle::default(),
        &spun([1e-6, 2.0, 0.0]),
        40.0,
    );
    let thrown = Spatial {
        angular_velocity: [3.0, 0.5, -0.9].into(),
        ..Spatial::default()
    };
    measure(
        "thrown, principal axes found in `new`",
        &Tilted::default(),
        &thrown,
        10.0,
    );
    for (what, tilt, rates) in [
        ("Lagrange's top", 1.0, [0.5, 0.3, 20.0]),
        ("sleeping top", 1e-3, [0.0, 0.0, 40.0]),
        ("falling top", 1e-3, [0.0, 0.0, 1.0]),
    ] {
        let start = Rotation {
            attitude: attitude::exp(&[tilt, 0.0, 0.0].into()),
            angular_velocity: rates.into(),
        };
        measure(what, &Top::default(), &start, 100.0);
    }
    for (what, wobble, spin, span) in [
        ("spun up", 0.3, 20.0, 100.0),
        ("spun down and up, all of it", 0.3, -100.0, 100.0),
        ("spun down and up, while it reverses", 0.3, -20.0, 20.0),
        ("spun up, with a fast wobble", 9.0, 0.0, 100.0),
    ] {
        measure(what, &Stage::default(), &spun([wobble, 0.0, spin]), span);
    }
    for (what, angular_velocity) in [("pendulum, swinging", 3.0), ("pendulum, going round", 9.0)] {
        let start = Hinge {
            angle: 0.5,
            angular_velocity,
        };
        measure(what, &Clock::default(), &start, 10.0);
    }
}
