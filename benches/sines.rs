//! Sines and cosines in lanes: ns per pair, in registers of each width, and relative to a single
//! lane, which is computed by libm. Then the five pairs of one state of a robot, by libm.
//!
//! The shortest time of many rounds is taken, in one thread, including loads and stores. Run
//! `cargo bench --bench sines`.

use std::hint::black_box;
use std::time::Instant;

use newton_euler::ensemble::Ensemble;
use newton_euler::lanes::Width;
use newton_euler::prelude::*;

rigid_body!(Circle::<T> {
    motion: planar_translation,
    params: [force = 1[N]],
    inputs: [angle],
    mass: 1[kg],
    forces: [radius = force * world(angle.cos(), angle.sin())],
});

// the angles of a robot, with little else to compute
rigid_body!(Robot {
    motion: planar_translation,
    params: [force = 1[N]],
    inputs: [a, b, c, d, e],
    mass: 1[kg],
    forces: [
        first = force * world(a.cos(), a.sin()),
        second = force * world(b.cos(), b.sin()),
        third = force * world(c.cos(), c.sin()),
        fourth = force * world(d.cos(), d.sin()),
        fifth = force * world(e.cos(), e.sin()),
    ],
});

/// The number of members. Their columns stay in the cache next to the core.
const COUNT: usize = 512;

/// The ns per member, in registers of this width, for angles up to this size.
fn measure(width: Width, size: f64) -> f64 {
    let rest = PlanarTranslation::default();
    let mut members = Ensemble::new(&Circle::default(), (0..COUNT).map(|_| rest));
    members.set_width(width);
    for index in 0..COUNT {
        #[expect(clippy::cast_precision_loss, reason = "small")]
        let angle = size * ((index as f64 * 0.618).fract() * 2.0 - 1.0);
        members.inputs_mut().set(index, &CircleInput { angle });
    }
    let mut found = members.accelerations(0.0);
    shortest(|| black_box(&members).accelerate(0.0, black_box(&mut found)))
}

/// The ns of the five pairs of one state, for angles up to this size.
fn measure_five(size: f64) -> f64 {
    let (robot, rest) = (Robot::default(), PlanarTranslation::default());
    #[expect(clippy::cast_precision_loss, reason = "small")]
    let angle = |index: usize| size * ((index as f64 * 0.618).fract() * 2.0 - 1.0);
    let inputs = (0..COUNT).map(|index| {
        let [a, b, c, d, e] = core::array::from_fn(|axis| angle(5 * index + axis));
        RobotInput { a, b, c, d, e }
    });
    let inputs: Vec<RobotInput> = inputs.collect();
    shortest(|| {
        for input in black_box(&inputs) {
            black_box(robot.acceleration(0.0, &rest, input));
        }
    })
}

/// The ns per member of the shortest of many rounds.
fn shortest(mut round: impl FnMut()) -> f64 {
    let rounds = (0..2000).map(|_| {
        let start = Instant::now();
        round();
        start.elapsed().as_secs_f64()
    });
    #[expect(clippy::cast_precision_loss, reason = "small")]
    let members = COUNT as f64;
    rounds.fold(f64::INFINITY, f64::min) * 1e9 / members
}

fn main() {
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    println!("| angles up to | {:>8} | ns | of one lane |", "lanes");
    for size in [0.7, 10.0, 1000.0, 1e5] {
        let one = measure(Width::One, size);
        for width in Width::ALL.into_iter().filter(|width| width.is_there()) {
            let ns = measure(width, size);
            println!(
                "| {size:12} | {:>8} | {ns:.2} | {:.2} |",
                width.lanes(),
                ns / one
            );
        }
    }
    println!("| angles up to | five pairs, ns |");
    for size in [0.7, 3.1, 10.0] {
        println!("| {size:12} | {:.1} |", measure_five(size));
    }
}
