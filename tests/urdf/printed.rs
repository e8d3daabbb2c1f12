//! What the descriptions with files amount to, as `describe` prints it.

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

rigid_system!(GripperPrinted {
    params: [tilt],
    bodies: [
        rail {
            mass: 0[kg],
            points: [origin = (0, 0, 0), carriage_joint = (0, 0.1, 0)],
        },
        carriage {
            mass: 1.5,
            inertia: tensor {
                xx: 0.004,
                yy: 0.005,
                zz: 0.003,
                xy: 0,
                yz: 0,
                zx: 0.0005
            },
            points: [origin = (-0.02, 0, -0.04), turn = (-0.02, 0, 0.1 - 0.04)],
        },
        palm {
            mass: 0.7,
            inertia: tensor {
                xx: 0.0012,
                yy: 0.0015,
                zz: 0.0008,
                xy: 0,
                yz: 0,
                zx: 0
            }
            .turned(body(1, 0, 0), 0.3),
            points: [
                origin = (0, -0.01, -0.05),
                finger_1 = (0, 0.02 - 0.01, 0.09 - 0.05),
                finger_2 = (0, -0.02 - 0.01, 0.09 - 0.05),
                tool_tilt = (0.01, -0.01, 0.12 - 0.05),
            ],
        },
        left {
            mass: 0.05,
            inertia: tensor {
                xx: 0.00002,
                yy: 0.000018,
                zz: 0.000006,
                xy: 0,
                yz: 0,
                zx: 0
            },
            points: [origin = (0, -0.004, -0.02)],
        },
        right {
            mass: 0.05,
            inertia: tensor {
                xx: 0.00002,
                yy: 0.000018,
                zz: 0.000006,
                xy: 0,
                yz: 0,
                zx: 0
            },
            points: [
                origin = (0, 0.004, -0.02),
                finger_2 = origin - 15[mm] * body(0, -3, 4).normalize(),
            ],
        },
        tool {
            mass: 0.2,
            inertia: tensor {
                xx: 0.0002,
                yy: 0.00025,
                zz: 0.0001,
                xy: 0,
                yz: 0,
                zx: 0
            },
            points: [origin = (-0.01, -0.02, -0.03)],
        },
    ],
    joints: [
        pedestal = weld(world(0.5, 0, 0.2), rail.origin).turned(body(0, 0, 1), 180[deg]),
        carriage_joint = prismatic(rail.carriage_joint, carriage.origin, body(0, 0, 1))
            .turned(body(0, 1, 0), 90[deg]),
        turn = revolute(carriage.turn, palm.origin, body(0, -1, 0)).turned(body(0, 0, 1), -0.4),
        finger_1 = prismatic(palm.finger_1, left.origin, body(0, 1, 0)),
        finger_2 = weld(palm.finger_2, right.finger_2).turned(body(0, 0, 1), 0.3),
        tool_tilt = weld(palm.tool_tilt, tool.origin)
            .turned(body(0, 1, 0), 0.1)
            .turned(body(1, 0, 0), 0.2)
            .turned(body(0, 0.6, 0.8), tilt),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});

rigid_system!(QuadrupedPrinted {
    inputs: [push[N]],
    bodies: [
        trunk {
            mass: 9.5,
            inertia: tensor {
                xx: 0.21,
                yy: 0.09,
                zz: 0.25,
                xy: 0.002,
                yz: 0.003,
                zx: -0.001
            },
            points: [
                origin = (0, -0.01, -0.02),
                handle = origin + body(0, 0, 0.1),
            ],
            forces: [shove = world(push, 0, 0).at(handle)],
        },
        load {
            mass: 2[kg],
            inertia: sphere(0.1[m]),
        },
        base {
            mass: 0[kg],
            points: [
                trunk_mount = (0.02, 0, 0.05),
                front_left_hip = (0.25, 0.11, 0.01),
                front_right_hip = (0.25, -0.11, 0.01),
                hind_left_hip = (-0.25, 0.11, 0.01),
                hind_right_hip = (-0.25, -0.11, 0.01),
            ],
        },
        front_left_thigh {
            mass: 1.1,
            inertia: tensor {
                xx: 0.008,
                yy: 0.009,
                zz: 0.003,
                xy: 0.0001,
                yz: -0.0003,
                zx: 0.0002
            }
            .turned(body(1, 0, 0), 0.1)
            .turned(body(0, 0, 1), 0.2),
            points: [
                origin = (-0.01, -0.03, 0.12),
                front_left_knee = (-0.01, 0.05 - 0.03, -0.25 + 0.12),
            ],
        },
        front_left_shank {
            mass: 0.5,
            inertia: tensor {
                xx: 0.003,
                yy: 0.0031,
                zz: 0.0002,
                xy: 0,
                yz: 0,
                zx: 0
            },
            points: [
                origin = (-0.005, 0, 0.11),
                front_left_ankle = (-0.005, 0, -0.26 + 0.11),
            ],
        },
        front_left_foot {
            mass: 0.06,
            inertia: tensor {
                xx: 0.00002,
                yy: 0.00002,
                zz: 0.00002,
                xy: 0,
                yz: 0,
                zx: 0
            },
            points: [origin = (0, 0, 0)],
        },
        front_right_thigh {
            mass: 1.1,
            inertia: tensor {
                xx: 0.008,
                yy: 0.009,
                zz: 0.003,
                xy: 0.0001,
                yz: -0.0003,
                zx: 0.0002
            }
            .turned(body(1, 0, 0), 0.1)
            .turned(body(0, 0, 1), -0.2),
            points: [
                origin = (-0.01, 0.03, 0.12),
                front_right_knee = (-0.01, -0.05 + 0.03, -0.25 + 0.12),
            ],
        },
        front_right_shank {
            mass: 0.5,
            inertia: tensor {
                xx: 0.003,
                yy: 0.0031,
                zz: 0.0002,
                xy: 0,
                yz: 0,
                zx: 0
            },
            points: [
                origin = (-0.005, 0, 0.11),
                front_right_ankle = (-0.005, 0, -0.26 + 0.11),
            ],
        },
        front_right_foot {
            mass: 0.06,
            inertia: tensor {
                xx: 0.00002,
                yy: 0.00002,
                zz: 0.00002,
                xy: 0,
                yz: 0,
                zx: 0
            },
            points: [origin = (0, 0, 0)],
        },
        hind_left_thigh {
            mass: 1.1,
            inertia: tensor {
                xx: 0.008,
                yy: 0.009,
                zz: 0.003,
                xy: 0.0001,
                yz: -0.0003,
                zx: 0.0002
            }
            .turned(body(1, 0, 0), -0.1)
            .turned(body(0, 0, 1), 0.2),
            points: [
                origin = (-0.01, -0.03, 0.12),
                hind_left_knee = (-0.01, 0.05 - 0.03, -0.25 + 0.12),
            ],
        },
        hind_left_shank {
            mass: 0.5,
            inertia: tensor {
                xx: 0.003,
                yy: 0.0031,
                zz: 0.0002,
                xy: 0,
                yz: 0,
                zx: 0
            },
            points: [
                origin = (-0.005, 0, 0.11),
                hind_left_ankle = (-0.005, 0, -0.26 + 0.11),
            ],
        },
        hind_left_foot {
            mass: 0.06,
            inertia: tensor {
                xx: 0.00002,
                yy: 0.00002,
                zz: 0.00002,
                xy: 0,
                yz: 0,
                zx: 0
            },
            points: [origin = (0, 0, 0)],
        },
        hind_right_thigh {
            mass: 1.1,
            inertia: tensor {
                xx: 0.008,
                yy: 0.009,
                zz: 0.003,
                xy: 0.0001,
                yz: -0.0003,
                zx: 0.0002
            }
            .turned(body(1, 0, 0), -0.1)
            .turned(body(0, 0, 1), -0.2),
            points: [
                origin = (-0.01, 0.03, 0.12),
                hind_right_knee = (-0.01, -0.05 + 0.03, -0.25 + 0.12),
            ],
        },
        hind_right_shank {
            mass: 0.5,
            inertia: tensor {
                xx: 0.003,
                yy: 0.0031,
                zz: 0.0002,
                xy: 0,
                yz: 0,
                zx: 0
            },
            points: [
                origin = (-0.005, 0, 0.11),
                hind_right_ankle = (-0.005, 0, -0.26 + 0.11),
            ],
        },
        hind_right_foot {
            mass: 0.06,
            inertia: tensor {
                xx: 0.00002,
                yy: 0.00002,
                zz: 0.00002,
                xy: 0,
                yz: 0,
                zx: 0
            },
            points: [origin = (0, 0, 0)],
        },
    ],
    joints: [
        trunk_mount = weld(base.trunk_mount, trunk.origin).turned(body(0, 0, 1), 90[deg]),
        front_left_hip = revolute(base.front_left_hip, front_left_thigh.origin, body(1, 0, 0)),
        front_left_knee = revolute(
            front_left_thigh.front_left_knee,
            front_left_shank.origin,
            body(0, 1, 0)
        )
        .turned(body(0, 1, 0), 0.3),
        front_left_ankle = weld(front_left_shank.front_left_ankle, front_left_foot.origin),
        front_right_hip = revolute(
            base.front_right_hip,
            front_right_thigh.origin,
            body(1, 0, 0)
        ),
        front_right_knee = revolute(
            front_right_thigh.front_right_knee,
            front_right_shank.origin,
            body(0, 1, 0)
        )
        .turned(body(0, 1, 0), 0.3),
        front_right_ankle = weld(front_right_shank.front_right_ankle, front_right_foot.origin),
        hind_left_hip = revolute(base.hind_left_hip, hind_left_thigh.origin, body(-1, 0, 0)),
        hind_left_knee = revolute(
            hind_left_thigh.hind_left_knee,
            hind_left_shank.origin,
            body(0, 1, 0)
        )
        .turned(body(0, 1, 0), -0.3),
        hind_left_ankle = weld(hind_left_shank.hind_left_ankle, hind_left_foot.origin),
        hind_right_hip = revolute(base.hind_right_hip, hind_right_thigh.origin, body(-1, 0, 0)),
        hind_right_knee = revolute(
            hind_right_thigh.hind_right_knee,
            hind_right_shank.origin,
            body(0, 1, 0)
        )
        .turned(body(0, 1, 0), -0.3),
        hind_right_ankle = weld(hind_right_shank.hind_right_ankle, hind_right_foot.origin),
        root = free(base),
        strap = weld(trunk.handle, load.G),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [cord = 3[N].between(front_left_foot.origin, hind_right_foot.origin)],
    outputs: [energy, momentum],
});

rigid_system!(SensorPrinted {
    bodies: [
        camera {
            mass: 0.2[kg],
            inertia: principal(1e-4, 2e-4, 1.5e-4),
            points: [origin = (0, 0, 0), tilt = (0, 0, 0.05)],
        },
        lens {
            mass: 0.1[kg],
            inertia: sphere(0.03[m]),
        },
        cart {
            mass: 1.5,
            inertia: tensor {
                xx: 0.004,
                yy: 0.005,
                zz: 0.003,
                xy: 0,
                yz: 0,
                zx: 0.0005
            },
            points: [origin = (-0.02, 0, -0.04), turn = (-0.02, 0, 0.1 - 0.04)],
        },
        palm {
            mass: 0.7,
            inertia: tensor {
                xx: 0.0012,
                yy: 0.0015,
                zz: 0.0008,
                xy: 0,
                yz: 0,
                zx: 0
            }
            .turned(body(1, 0, 0), 0.3),
            points: [origin = (0, -0.01, -0.05), pan = (0.1, -0.01, 0.2 - 0.05)],
        },
        plate {
            mass: 0[kg],
            points: [origin = (0, 0, 0)],
        },
    ],
    joints: [
        rail =
            prismatic(world(0, 0.1, 0), cart.origin, body(0, 0, 1)).turned(body(0, 1, 0), 90[deg]),
        turn = revolute(cart.turn, palm.origin, body(0, -1, 0)).turned(body(0, 0, 1), -0.4),
        pan = revolute(palm.pan, camera.origin, body(0, 0, 1)),
        tilt = revolute(camera.tilt, plate.origin, body(0, 1, 0)),
        glue = weld(plate.origin, lens.G),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});
