//! A double pendulum: chaotic motion with conserved energy.
//!
//! The upper arm hangs from the origin of the world, the lower one from its tip; angles are
//! anticlockwise, that of the elbow from the upper arm to the lower.
//!
//! Asserts: accelerations to 20 digits in one state; after ten seconds two motions that begin
//! 1e-9 rad apart have separated completely, and each has conserved its energy.

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
}
