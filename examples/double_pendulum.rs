//! A double pendulum: chaotic motion with conserved energy.
//!
//! The upper arm hangs from the origin of the world, and the lower one from the tip of the upper.
//! Angles are counterclockwise; that of the elbow is from the upper arm to the lower.
//!
//! Asserts: accelerations to 20 digits in one state; after twenty seconds two motions that begin
//! 1e-9 rad apart have separated; a motion of a thousand seconds has conserved its energy to 1e-12.
//!
//! `cargo run --release --example double_pendulum -- path.svg` also draws the path of the tip in the
//! first twelve seconds; `-- motion.html` makes a page that shows the motion.

use std::path::Path;

use nalgebra::Vector3;
use newton_euler::integrate::Sample;
use newton_euler::pictures::{Page, Plot, Pose, Solid};
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
    println!("\nfrom rest at 2.6 rad, and 1e-9 rad further");
    let ends = [2.6, 2.6 + 1e-9].map(|angle| {
        let motion = pendulum.integrate(&start(angle)).tolerance(1e-12);
        let end = motion.to(20.0).expect("no switch, no wall");
        println!("  after 20 s: elbow {:9.4} rad", end.elbow.angle);
        end
    });
    assert!((ends[0].elbow.angle - ends[1].elbow.angle).abs() > 1e-6);

    let energy = |state: &DoublePendulumState| {
        pendulum.kinetic_energy(state) + pendulum.potential_energy(0.0, state, &())
    };
    let motion = pendulum.integrate(&start(2.6)).tolerance(1e-15);
    let end = motion.to(1000.0).expect("no switch, no wall");
    let lost = (energy(&end) / energy(&start(2.6)) - 1.0).abs();
    println!("  after 1000 s: energy off by {lost:.1e} of itself");
    assert!(lost < 1e-12);

    if let Some(path) = std::env::args().nth(1) {
        let motion = pendulum.integrate(&start(2.6)).tolerance(1e-12);
        let samples = motion.samples(12.0, 0.01).collect::<Result<Vec<_>, _>>();
        draw(&path, &samples.expect("no switch, no wall")).expect("a path to write to");
    }
}

/// The path of the tip as SVG, or the motion of both arms as a page.
fn draw(path: &str, samples: &[Sample<DoublePendulumState>]) -> std::io::Result<()> {
    let upper = |state: &DoublePendulumState| Pose::planar([0.0; 2], state.shoulder.angle);
    let lower = |state: &DoublePendulumState| {
        let (sine, cosine) = state.shoulder.angle.sin_cos();
        let elbow = [0.6 * cosine, 0.6 * sine];
        Pose::planar(elbow, state.shoulder.angle + state.elbow.angle)
    };
    let tip = |state: &DoublePendulumState| {
        let Pose { position, attitude } = lower(state);
        position + attitude * Vector3::new(0.44, 0.0, 0.0)
    };
    let plot = Plot::empty(samples)
        .against("x", "m", |_, state| tip(state).x)
        .curve("y", "m", |_, state| tip(state).y)
        .to_scale();
    if Path::new(path)
        .extension()
        .is_none_or(|ending| ending != "html")
    {
        return plot.write(path);
    }
    let arm = |length: f64| Solid::bar([0.0; 3], [length, 0.0, 0.0], 0.04);
    let angles = Plot::of(samples, &["shoulder.angle", "elbow.angle"]);
    Page::of(samples)
        .title("A double pendulum")
        .solid_at(arm(0.6), |_, state| upper(state))
        .solid_at(arm(0.44), |_, state| lower(state))
        .from_front()
        .plot(angles.expect("two joints"))
        .plot(plot)
        .write(path)
}
