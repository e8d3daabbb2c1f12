//! A double pendulum: chaotic motion with conserved energy.
//!
//! The upper arm hangs from the origin of the world, the lower one from its tip; angles are
//! anticlockwise, that of the elbow from the upper arm to the lower.
//!
//! Asserts: accelerations to 20 digits in one state; after twenty seconds two motions that begin
//! 1e-9 rad apart have separated, and each has conserved its energy.
//!
//! `cargo run --release --example double_pendulum -- path.svg` also draws the first twelve seconds.

use std::fmt::Write as _;

use newton_euler::integrate::Sample;
use newton_euler::prelude::*;

rigid_system!(DoublePendulum {
    doc: "Two arms in the plane, hinged to each other and to the ground.",
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
    outputs: [energy, reactions(elbow)],
});

fn main() {
    let pendulum = DoublePendulum::default();
    println!("{}\n", DoublePendulum::EQUATIONS);

    let state = DoublePendulumState {
        shoulder: Hinge {
            angle: 0.9,
            angular_velocity: 2.1,
        },
        elbow: Hinge {
            angle: -1.3,
            angular_velocity: -5.4,
        },
    };
    let acceleration = pendulum.acceleration(0.0, &state, &());
    let off = (acceleration.shoulder + 13.462_694_066_232_725)
        .abs()
        .max((acceleration.elbow + 0.697_884_914_458_211_5).abs());
    println!("in a state of the references");
    println!(
        "  accelerations {:.6} and {:.6} rad/s²",
        acceleration.shoulder, acceleration.elbow
    );
    println!("  off by        {off:.1e} rad/s²");
    assert!(off < 1e-12);

    // nearly upright: chaos
    let start = |angle: f64| DoublePendulumState {
        shoulder: Hinge {
            angle,
            angular_velocity: 0.0,
        },
        ..DoublePendulumState::default()
    };
    let energy = |state: &DoublePendulumState| {
        pendulum.kinetic_energy(state) + pendulum.potential_energy(0.0, state, &())
    };
    println!("\nfrom rest at 2.6 rad, and 1e-9 rad further");
    let ends = [2.6, 2.6 + 1e-9].map(|angle| {
        let start = start(angle);
        let end = pendulum
            .integrate(&start)
            .tolerance(1e-12)
            .to(20.0)
            .expect("no switch, no wall");
        let lost = (energy(&end) - energy(&start)).abs();
        println!(
            "  after 20 s: elbow {:9.4} rad, energy off by {lost:.1e} J",
            end.elbow.angle
        );
        assert!(lost < 1e-10);
        end
    });
    assert!((ends[0].elbow.angle - ends[1].elbow.angle).abs() > 1e-6);

    if let Some(path) = std::env::args().nth(1) {
        let motion = pendulum.integrate(&start(2.6)).tolerance(1e-12);
        let samples = motion.samples(12.0, 0.01);
        let samples = samples.map(|sample| sample.expect("no switch, no wall"));
        std::fs::write(&path, picture(&samples.collect::<Vec<_>>())).expect("a path to write to");
    }
}

/// Elbow and tip, in pixels: the lower arm ends as far below its center of mass as its hinge is
/// above.
fn places(state: &DoublePendulumState) -> [[f64; 2]; 2] {
    let upper = state.shoulder.angle;
    let lower = upper + state.elbow.angle;
    let elbow = [0.6 * upper.cos(), 0.6 * upper.sin()];
    let tip = [elbow[0] + 0.44 * lower.cos(), elbow[1] + 0.44 * lower.sin()];
    [elbow, tip].map(|[x, y]| [230.0 + 200.0 * x, 230.0 - 200.0 * y])
}

/// The path of the tip, from light to dark, and the arms at the end.
fn picture(samples: &[Sample<DoublePendulumState>]) -> String {
    let mut drawn = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 460 460\" width=\"460\">\n\
         <rect width=\"460\" height=\"460\" fill=\"white\"/>\n",
    );
    let duration = samples.last().map_or(1.0, |sample| sample.time);
    for pair in samples.windows(2) {
        let [[x, y], [to_x, to_y]] = [pair[0], pair[1]].map(|sample| places(&sample.state)[1]);
        let _ = writeln!(
            drawn,
            "<path d=\"M{x:.1} {y:.1}L{to_x:.1} {to_y:.1}\" stroke=\"#0b5c8c\" opacity=\"{:.2}\"/>",
            0.15 + 0.85 * pair[1].time / duration
        );
    }
    let [[x, y], [to_x, to_y]] = places(&samples[samples.len() - 1].state);
    let _ = writeln!(
        drawn,
        "<path d=\"M230 230L{x:.1} {y:.1}L{to_x:.1} {to_y:.1}\" fill=\"none\" stroke=\"#c44e1a\" \
         stroke-width=\"5\" stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n</svg>"
    );
    drawn
}
