//! A crane: a trolley on a rail, a hoist that lets out a rope, and a load on a ball joint below.
//!
//! World z is up. A slide stands for the rope. This is correct while the force of the slide, which
//! `reactions` gives, points upward.
//!
//! Asserts: at rest the rope carries hook and load; the period of small swings is that of a
//! compound pendulum; a trolley that stops at the right time leaves no swing.

use newton_euler::prelude::*;

rigid_system!(Crane {
    doc: "Trolley, hoist and load.",
    inputs: [pull[N], hoist[N]],
    bodies: [
        trolley {
            mass: 400[kg],
            inertia: principal(40, 30, 50)[kg * m ^ 2]
        },
        swivel {
            mass: 20[kg],
            inertia: principal(0.2, 0.2, 0.2)[kg * m ^ 2]
        },
        load {
            mass: 1000[kg],
            inertia: principal(300, 320, 280)[kg * m ^ 2],
            points: [eye = (0, 0, 1)[m]],
        },
    ],
    joints: [
        rail = prismatic(world(0, 0, 12[m]), trolley.G, body(1, 0, 0)),
        hang = universal(trolley.G, swivel.G, body(0, 1, 0), body(1, 0, 0)),
        rope = prismatic(swivel.G, load.eye, body(0, 0, -1)),
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    drives: [motor = pull.on(rail), drum = (-hoist).on(rope)],
    outputs: [energy, reactions],
});

fn main() {
    let crane = Crane::default();
    let length = 5.0;
    let hanging = CraneState {
        rope: Slide {
            position: length,
            velocity: 0.0,
        },
        ..CraneState::default()
    };
    let hoist = 1000.0 * 9.80665;
    let held = CraneInput { pull: 0.0, hoist };
    let still = crane.acceleration(0.0, &hanging, &held);
    println!("at rest: the rope accelerates by {:.1e} m/s²", still.rope);
    assert!(still.rope.abs() < 1e-12);
    let carried = crane.reactions(0.0, &hanging, &held).rope.force.z;
    println!("         the rope carries {carried:.2} N");
    assert!((carried - hoist).abs() < 1e-9);

    // across the rail the trolley is fixed: a compound pendulum
    let tilted = CraneState {
        hang: Universal {
            angle_2: 1e-4,
            ..Universal::default()
        },
        ..hanging
    };
    let alpha = crane.acceleration(0.0, &tilted, &held).hang.y;
    let center = length + 1.0;
    let inertia = 300.0 + 1000.0 * center * center + 0.2;
    let square = 1000.0 * 9.80665 * center / inertia;
    println!(
        "swing across the rail: period {:.4} s",
        core::f64::consts::TAU / square.sqrt()
    );
    assert!((alpha / -1e-4 - square).abs() < 1e-6 * square);
}
