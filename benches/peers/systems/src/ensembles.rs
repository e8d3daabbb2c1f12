//! Ensembles of systems: bodies that are generic over their scalar.

use std::time::Instant;

use newton_euler::ensemble::Ensemble;
use newton_euler::integrate::{DormandPrince8, Fixed};
use newton_euler::prelude::*;

rigid_system!(Arm::<T> {
    doc: "The shoulder of a UR5, its arms and a load.",
    bodies: [
        shoulder {
            mass: 3.7[kg],
            inertia: principal(0.010267495893, 0.010267495893, 0.00666)[kg * m ^ 2],
            points: [out = (0, 0.13585, 0)],
        },
        upper_arm {
            mass: 8.393[kg],
            inertia: principal(0.22689067591, 0.22689067591, 0.0151074)[kg * m ^ 2],
            points: [from = (0, 0, -0.28), out = (0, -0.1197, 0.145)],
        },
        forearm {
            mass: 2.275[kg],
            inertia: principal(0.049443313556, 0.049443313556, 0.004095)[kg * m ^ 2],
            points: [from = (0, 0, -0.25), out = (0, 0, 0.14225)],
        },
        load {
            mass: 2.6[kg],
            inertia: principal(0.1, 0.12, 0.15)[kg * m ^ 2],
            points: [from = (0.02, -0.1, 0.03)],
        },
    ],
    joints: [
        pan = revolute(world(0, 0, 0.089159)[m], shoulder.G, body(0, 0, 1)),
        lift = revolute(shoulder.out, upper_arm.from, body(0, 1, 0)).turned(body(0, 1, 0), 90[deg]),
        elbow = revolute(upper_arm.out, forearm.from, body(0, 1, 0)),
        wrist = revolute(forearm.out, load.from, body(0, 0, 1)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});

/// The time in ns of a step of one of a thousand arms.
#[unsafe(no_mangle)]
pub extern "C" fn ensemble() -> f64 {
    let hinge = |angle: f64| Hinge {
        angle,
        angular_velocity: 1.0 - angle,
    };
    let bent = |k: u32| ArmState {
        pan: hinge(0.0),
        lift: hinge(-0.5),
        elbow: hinge(0.001 * f64::from(k)),
        wrist: hinge(0.3),
    };
    let mut arms = Ensemble::new(&Arm::default(), (0..1024).map(bent));
    let (method, step) = (DormandPrince8, 1e-3);
    let start = Instant::now();
    let moved = arms.integrate().method(Fixed { method, step }).to(2e-3);
    moved.expect("a regular motion");
    start.elapsed().as_secs_f64() * 1e9 / 2048.0
}
