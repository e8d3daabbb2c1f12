//! A satellite with three reaction wheels: it rotates by spinning them, and its angular momentum is
//! conserved.
//!
//! Body axes of the hub are those of the world at the identity attitude, with a wheel on each
//! of them. The wheels are symmetric, so the equations contain no sine (see `SKIPPED`).
//!
//! Asserts: accelerations to 20 digits in one state; the total momentum after a rotation.

use newton_euler::prelude::*;

rigid_system!(Satellite {
    doc: "A hub and three wheels along its axes.",
    inputs: [torque_x[N * m], torque_y[N * m], torque_z[N * m]],
    bodies: [
        hub {
            mass: 120[kg],
            inertia: principal(12, 14, 9)[kg * m ^ 2],
            points: [
                px = (0.3, 0, 0)[m],
                py = (0, 0.3, 0)[m],
                pz = (0, 0, 0.3)[m]
            ],
        },
        wheel {
            copies: [x = body(1, 0, 0), y = body(0, 1, 0), z = body(0, 0, 1)],
            mass: 4[kg],
            inertia: cylinder(0.13[m], 0.04[m]),
        },
    ],
    joints: [
        orbit = free(hub),
        spin_x = revolute(hub.px, wheel_x.G, body(1, 0, 0)),
        spin_y = revolute(hub.py, wheel_y.G, body(0, 1, 0)),
        spin_z = revolute(hub.pz, wheel_z.G, body(0, 0, 1)),
    ],
    drives: [
        motor_x = torque_x.on(spin_x),
        motor_y = torque_y.on(spin_y),
        motor_z = torque_z.on(spin_z),
    ],
    outputs: [momentum, energy],
});

fn main() {
    let satellite = Satellite::default();
    for line in Satellite::SKIPPED {
        println!("left out: {line}");
    }
    let costs = Satellite::OPERATIONS.iter();
    for cost in costs.filter(|cost| cost.function == "acceleration") {
        println!(
            "acceleration: {} mul, {} add, {} trig\n",
            cost.mul, cost.add, cost.trig
        );
    }

    let start = SatelliteState {
        orbit: Spatial {
            angular_velocity: [0.01, -0.02, 0.015].into(),
            ..Spatial::default()
        },
        spin_x: Hinge {
            angle: 0.0,
            angular_velocity: 40.0,
        },
        ..SatelliteState::default()
    };
    let input = SatelliteInput {
        torque_x: -0.05,
        torque_y: 0.02,
        torque_z: 0.03,
    };
    let momentum = |state: &SatelliteState| satellite.angular_momentum(state);
    let motion = satellite.integrate(&start).input(input).tolerance(1e-12);
    let end = motion.to(60.0).expect("a smooth motion");
    let off = (momentum(&end) - momentum(&start)).norm();
    println!("after a minute of constant torques of the motors");
    println!(
        "  the hub has turned by {:.4} rad",
        end.orbit.attitude.angle()
    );
    println!("  wheel x is at {:.3} rad/s", end.spin_x.angular_velocity);
    println!(
        "  angular momentum {:.6} N m s, off by {off:.1e}",
        momentum(&end).norm()
    );
    assert!(off < 1e-11);
    assert!(
        end.orbit.velocity.norm() < 1e-2,
        "only the center of the whole stays"
    );
    assert!(
        satellite.linear_momentum(&end).norm() < 1e-9 + satellite.linear_momentum(&start).norm()
    );
}
