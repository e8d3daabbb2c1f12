//! The description of a file with all its values, as `describe` prints it.

use newton_euler::prelude::*;

rigid_system!(ArmPrinted {
    inputs: [torque[N * m]],
    bodies: [
        base_plate {
            mass: 3,
            inertia: tensor {
                xx: 0.02,
                yy: 0.02,
                zz: 0.03,
                xy: 0,
                yz: 0,
                zx: 0
            },
            points: [
                origin = (-0.01, 0.02, -0.03),
                shoulder = (0.1 - 0.01, 0.2 + 0.02, 0.35 - 0.03),
            ],
        },
        upper_arm {
            mass: 2.5,
            inertia: tensor {
                xx: 0.031,
                yy: 0.034,
                zz: 0.011,
                xy: 0.002,
                yz: 0.003,
                zx: -0.001
            }
            .turned(body(1, 0, 0), 0.7)
            .turned(body(0, 1, 0), 0.4)
            .turned(body(0, 0, 1), -1.1),
            points: [
                origin = (-0.02, -0.01, -0.18),
                elbow = (0.03 - 0.02, -0.04 - 0.01, 0.37 - 0.18),
            ],
        },
        fore_arm {
            mass: 1.4,
            inertia: tensor {
                xx: 0.012,
                yy: 0.013,
                zz: 0.004,
                xy: 0.0005,
                yz: -0.0004,
                zx: 0.0003
            },
            points: [
                origin = (0.01, -0.015, -0.14),
                adapter_mount = (0.01, 0.02 - 0.015, 0.3 - 0.14),
            ],
        },
        adapter {
            mass: 0[kg],
            points: [origin = (0, 0, 0), telescope = (0.01, 0.02, 0.03)],
        },
        ram {
            mass: 0.6,
            inertia: tensor {
                xx: 0.002,
                yy: 0.003,
                zz: 0.0025,
                xy: 0,
                yz: 0,
                zx: 0
            }
            .turned(body(1, 0, 0), 0.1)
            .turned(body(0, 1, 0), 0.2)
            .turned(body(0, 0, 1), 0.3),
            points: [
                origin = (-0.05, -0.02, -0.01),
                wrist = (0.02 - 0.05, 0.05 - 0.02, -0.03 - 0.01),
            ],
        },
        hand {
            mass: 0.4,
            inertia: tensor {
                xx: 0.0011,
                yy: 0.0009,
                zz: 0.0007,
                xy: 0.0001,
                yz: 0,
                zx: 0
            },
            points: [
                origin = (-0.01, -0.03, -0.06),
                camera_mount = (0.02 - 0.01, -0.03, 0.08 - 0.06),
            ],
        },
        camera {
            mass: 0.15,
            inertia: tensor {
                xx: 0.0001,
                yy: 0.00012,
                zz: 0.00009,
                xy: 0,
                yz: 0,
                zx: 0
            }
            .turned(body(1, 0, 0), 0.2),
            points: [origin = (-0.001, -0.002, -0.01)],
        },
    ],
    joints: [
        shoulder = revolute(base_plate.shoulder, upper_arm.origin, body(0, 0, 1))
            .turned(body(0, 0, 1), 0.5)
            .turned(body(0, 1, 0), -0.2)
            .turned(body(1, 0, 0), 0.3),
        elbow = revolute(upper_arm.elbow, fore_arm.origin, body(0.6, 0, -0.8))
            .turned(body(0, 0, 1), 0.25)
            .turned(body(0, 1, 0), 0.9)
            .turned(body(1, 0, 0), -0.6),
        adapter_mount = weld(fore_arm.adapter_mount, adapter.origin)
            .turned(body(0, 0, 1), -0.7)
            .turned(body(0, 1, 0), 0.2)
            .turned(body(1, 0, 0), 0.4),
        telescope = prismatic(adapter.telescope, ram.origin, body(1, 2, 2))
            .turned(body(0, 0, 1), 0.8)
            .turned(body(0, 1, 0), -0.3)
            .turned(body(1, 0, 0), 1.2),
        wrist = revolute(ram.wrist, hand.origin, body(0, 1, 0))
            .turned(body(0, 0, 1), 0.2)
            .turned(body(1, 0, 0), -90[deg]),
        camera_mount = weld(hand.camera_mount, camera.origin)
            .turned(body(0, 0, 1), 0.15)
            .turned(body(0, 1, 0), -0.45)
            .turned(body(1, 0, 0), 0.35),
        base_plate_to_ground = weld(world(0, 0, 0), base_plate.origin),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [motor = torque.on(elbow)],
    outputs: [energy, momentum, reactions(shoulder)],
});
