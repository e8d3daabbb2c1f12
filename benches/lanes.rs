//! Motions of ensembles in registers of each width, relative to members that move one by one by
//! the same method, to the same bits.
//!
//! The shortest time of many rounds is taken, in one thread. Run `cargo bench --bench lanes`. To
//! count the instructions of one motion in an emulator, run the program with `top` or
//! `pendulum`, `adaptive` or `fixed`, the width (0 for one by one) and the number of members.

use std::hint::black_box;
use std::time::Instant;

use newton_euler::columns::Generic;
use newton_euler::ensemble::{Ensemble, Moves, OneByOne, Together};
use newton_euler::integrate::{DormandPrince8, Fixed, Verner};
use newton_euler::lanes::Width;
use newton_euler::prelude::*;

rigid_body!(Top::<T> {
    doc: "Products and sums only.",
    motion: fixed_point(foot),
    mass: 2[kg],
    inertia: principal(0.2, 0.3, 0.4)[kg * m ^ 2],
    points: [foot = (0, 0.05, -0.2[m])],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
});

rigid_system!(Pendulum::<T> {
    doc: "With the sines of two angles.",
    motion: planar,
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower {
            mass: 0.8[kg],
            inertia: 0.015[kg * m ^ 2],
            points: [hinge = (-0.22, 0)[m]]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
});

const END: f64 = 10.0;
const ADAPTIVE: Verner = Verner { tolerance: 1e-9 };
const FIXED: Fixed<DormandPrince8> = Fixed {
    method: DormandPrince8,
    step: 0.05,
};

/// Tops that spin at different rates.
fn tops(count: u16) -> Ensemble<Top<f64>> {
    let spin = |index: u16| Rotation {
        angular_velocity: [0.1, 1.0 + 0.001 * f64::from(index), 5.0].into(),
        ..Rotation::default()
    };
    Ensemble::new(&Top::default(), (0..count).map(spin))
}

/// Pendulums from different angles.
fn pendulums(count: u16) -> Ensemble<Pendulum<f64>> {
    let hung = |index: u16| PendulumState {
        shoulder: Hinge {
            angle: 0.5 + 5e-4 * f64::from(index),
            angular_velocity: 0.0,
        },
        ..PendulumState::default()
    };
    Ensemble::new(&Pendulum::default(), (0..count).map(hung))
}

/// Moves all members in registers of a width, or one by one.
fn moved<B, M>(mut ensemble: Ensemble<B>, method: M, width: Option<Width>) -> Ensemble<B>
where
    B: Generic + Integrate<Best: Together<B>>,
    M: Moves<B> + Copy,
    OneByOne<M>: Moves<B>,
{
    let end = if let Some(width) = width {
        ensemble.set_width(width);
        ensemble.integrate().method(method).to(END)
    } else {
        ensemble.integrate().method(OneByOne(method)).to(END)
    };
    end.expect("an end");
    ensemble
}

/// Prints a row of the table for each width.
fn compare<B, M>(name: &str, ensemble: &Ensemble<B>, method: M)
where
    B: Generic + Integrate<Best: Together<B>>,
    M: Moves<B> + Copy,
    OneByOne<M>: Moves<B>,
{
    let measure = |width: Option<Width>| {
        let rounds = (0..20).map(|_| {
            let members = ensemble.clone();
            let start = Instant::now();
            black_box(moved(black_box(members), method, width));
            start.elapsed().as_secs_f64()
        });
        rounds.fold(f64::INFINITY, f64::min)
    };
    let alone = measure(None);
    for width in Width::ALL.into_iter().filter(|width| width.is_there()) {
        let share = measure(Some(width)) / alone;
        println!("| {name:<20} | {:>5} | {share:.2} |", width.lanes());
    }
}

/// Moves members once.
fn once(arguments: &[String]) {
    let [body, method, width, count] = arguments else {
        panic!("body, method, width and number of members, not {arguments:?}");
    };
    let count: u16 = count.parse().expect("the number of members");
    let lanes: usize = width.parse().expect("the width");
    let width = Width::ALL.into_iter().find(|width| width.lanes() == lanes);
    let is_fixed = method == "fixed";
    if body == "top" && is_fixed {
        black_box(moved(tops(count), FIXED, width));
    } else if body == "top" {
        black_box(moved(tops(count), ADAPTIVE, width));
    } else if is_fixed {
        black_box(moved(pendulums(count), FIXED, width));
    } else {
        black_box(moved(pendulums(count), ADAPTIVE, width));
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if !arguments.iter().any(|argument| argument == "--bench") {
        if !arguments.is_empty() {
            once(&arguments);
        }
        return;
    }
    println!("| motion               | lanes | of one by one |");
    compare("tops, adaptive", &tops(512), ADAPTIVE);
    compare("tops, fixed", &tops(512), FIXED);
    compare("pendulums, adaptive", &pendulums(512), ADAPTIVE);
    compare("pendulums, fixed", &pendulums(512), FIXED);
}
