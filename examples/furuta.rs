//! A Furuta pendulum: a motor turns an arm about the vertical, and a pole swings on the tip of the
//! arm. The motor pumps energy into the pole to swing it up, and then balances it.
//!
//! Body axes of the pole: z from its center of mass G to the pin, along the pole, at angle
//! zero; the pole hangs at 0 and stands at π.
//!
//! Asserts: accelerations to 20 digits in one state; the pole stands after the swing.

use newton_euler::prelude::*;

rigid_system!(Furuta {
    doc: "An arm about the vertical, and a pole on its tip.",
    inputs: [torque[N * m]],
    bodies: [
        arm {
            mass: 0.3[kg],
            inertia: principal(1e-4, 1.2e-3, 1.2e-3)[kg * m ^ 2],
            points: [hub = (-0.1, 0, 0)[m], tip = (0.1, 0, 0)[m]],
        },
        pole {
            mass: 0.12[kg],
            inertia: principal(9e-4, 9e-4, 2e-5)[kg * m ^ 2],
            points: [pin = (0, 0, 0.15)[m]],
        },
    ],
    joints: [
        yaw = revolute(world(0, 0, 0), arm.hub, body(0, 0, 1)),
        swing = revolute(arm.tip, pole.pin, body(1, 0, 0)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [motor = torque.on(yaw)],
    outputs: [energy],
});

/// Pumps energy into the pole while it hangs, and balances it once it is nearly upright: the wanted
/// acceleration of the arm, and the torque that produces it, since accelerations are linear in the
/// torque.
fn motor(furuta: &Furuta, state: &FurutaState) -> FurutaInput {
    use core::f64::consts::PI;
    let (yaw, swing) = (&state.yaw, &state.swing);
    let tilt = (swing.angle + 2.0 * PI).rem_euclid(2.0 * PI) - PI;
    let wanted = if tilt.abs() < 0.5 {
        5.7 * yaw.angular_velocity - 180.0 * tilt - 25.7 * swing.angular_velocity
    } else {
        let (inertia, weight) = (0.0036, 0.12 * 9.81 * 0.15);
        let energy = 0.5 * inertia * swing.angular_velocity.powi(2) - weight * swing.angle.cos();
        let pump = (weight - energy) * swing.angular_velocity * swing.angle.cos();
        (-20.0 * pump).clamp(-20.0, 20.0) - yaw.angular_velocity
    };
    let arm = |torque| furuta.acceleration(0.0, state, &FurutaInput { torque }).yaw;
    let torque = (wanted - arm(0.0)) / (arm(1.0) - arm(0.0));
    FurutaInput {
        torque: torque.clamp(-1.0, 1.0),
    }
}

fn main() {
    let furuta = Furuta::default();
    println!("{}\n", Furuta::EQUATIONS);

    let state = FurutaState {
        yaw: Hinge {
            angle: 0.3,
            angular_velocity: 4.0,
        },
        swing: Hinge {
            angle: 2.8,
            angular_velocity: -1.5,
        },
    };
    let acceleration = furuta.acceleration(0.0, &state, &FurutaInput { torque: 0.02 });
    let off = (acceleration.yaw + 10.218_197_552_041_108)
        .abs()
        .max((acceleration.swing + 31.081_059_588_008_085).abs());
    println!("in a state of the references");
    println!(
        "  accelerations {:.6} and {:.6} rad/s²",
        acceleration.yaw, acceleration.swing
    );
    println!("  off by        {off:.1e} rad/s²");
    assert!(off < 1e-12);

    let mut state = FurutaState {
        swing: Hinge {
            angle: 0.1,
            angular_velocity: 0.0,
        },
        ..FurutaState::default()
    };
    println!("\nthe motor is asked every 5 ms");
    for step in 0..2000 {
        if step % 200 == 0 {
            println!(
                "  {:4.1} s: pole at {:7.3} rad",
                f64::from(step) * 0.005,
                state.swing.angle
            );
        }
        let input = motor(&furuta, &state);
        let motion = furuta.integrate(&state).input(input);
        state = motion.to(0.005).expect("nothing is out of range");
    }
    let upright = (state.swing.angle / core::f64::consts::PI).rem_euclid(2.0);
    println!("  10.0 s: pole at {:7.3} rad", state.swing.angle);
    assert!((upright - 1.0).abs() < 0.02, "the pole stands");
}
