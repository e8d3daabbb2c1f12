//! Descriptions of the files in this folder, and the same systems by hand.

use newton_euler::prelude::*;

rigid_system!(Arm {
    urdf: "tests/urdf/arm.urdf",
    inputs: [torque[N * m]],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [motor = torque.on(elbow)],
    outputs: [energy, momentum, reactions(shoulder)],
});

rigid_system!(ArmByHand {
    inputs: [torque[N * m]],
    bodies: [
        upper_arm {
            mass: 2.5[kg],
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
            points: [top = (-0.02, -0.01, -0.18), elbow = (0.01, -0.05, 0.19)],
        },
        fore_arm {
            mass: 1.4[kg],
            inertia: tensor {
                xx: 0.012,
                yy: 0.013,
                zz: 0.004,
                xy: 0.0005,
                yz: -0.0004,
                zx: 0.0003
            },
            points: [
                top = (0.01, -0.015, -0.14),
                telescope = (
                    0.0272192559669277587145977,
                    -0.000693043240239336446861406,
                    0.192727457625214152497487
                ),
            ],
        },
        ram {
            mass: 0.6[kg],
            inertia: principal(0.002, 0.003, 0.0025)
                .turned(body(1, 0, 0), 0.1)
                .turned(body(0, 1, 0), 0.2)
                .turned(body(0, 0, 1), 0.3),
            points: [top = (-0.05, -0.02, -0.01), wrist = (-0.03, 0.03, -0.04)],
        },
        hand {
            mass: 0.4[kg],
            inertia: tensor {
                xx: 0.0011,
                yy: 0.0009,
                zz: 0.0007,
                xy: 0.0001,
                yz: 0,
                zx: 0
            },
            points: [top = (-0.01, -0.03, -0.06), camera = (0.01, -0.03, 0.02)],
        },
        camera {
            mass: 0.15[kg],
            inertia: principal(0.0001, 0.00012, 0.00009).turned(body(1, 0, 0), 0.2),
            points: [top = (-0.001, -0.002, -0.01)],
        },
    ],
    joints: [
        shoulder = revolute(world(0.1, 0.2, 0.35), upper_arm.top, body(0, 0, 1))
            .turned(body(0, 0, 1), 0.5)
            .turned(body(0, 1, 0), -0.2)
            .turned(body(1, 0, 0), 0.3),
        elbow = revolute(upper_arm.elbow, fore_arm.top, body(0.6, 0, -0.8))
            .turned(body(0, 0, 1), 0.25)
            .turned(body(0, 1, 0), 0.9)
            .turned(body(1, 0, 0), -0.6),
        telescope = prismatic(fore_arm.telescope, ram.top, body(1, 2, 2))
            .turned(body(0, 0, 1), -0.7)
            .turned(body(0, 1, 0), 0.2)
            .turned(body(1, 0, 0), 0.4)
            .turned(body(0, 0, 1), 0.8)
            .turned(body(0, 1, 0), -0.3)
            .turned(body(1, 0, 0), 1.2),
        wrist = revolute(ram.wrist, hand.top, body(0, 1, 0))
            .turned(body(0, 0, 1), 0.2)
            .turned(body(1, 0, 0), -90[deg]),
        mount = weld(hand.camera, camera.top)
            .turned(body(0, 0, 1), 0.15)
            .turned(body(0, 1, 0), -0.45)
            .turned(body(1, 0, 0), 0.35),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [motor = torque.on(elbow)],
    outputs: [energy, momentum, reactions(shoulder)],
});

rigid_system!(Gripper {
    urdf: "tests/urdf/gripper.urdf",
    params: [tilt],
    locked: [tool_tilt = tilt, finger_2 = 15[mm]],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});

rigid_system!(GripperByHand {
    params: [tilt],
    bodies: [
        carriage {
            mass: 1.5[kg],
            inertia: tensor {
                xx: 0.004,
                yy: 0.005,
                zz: 0.003,
                xy: 0,
                yz: 0,
                zx: 0.0005
            },
            points: [foot = (-0.02, 0, -0.04), top = (-0.02, 0, 0.06)],
        },
        palm {
            mass: 0.7[kg],
            inertia: principal(0.0012, 0.0015, 0.0008).turned(body(1, 0, 0), 0.3),
            points: [
                foot = (0, -0.01, -0.05),
                one = (0, 0.01, 0.04),
                two = (0, -0.03, 0.04),
                tool = (0.01, -0.01, 0.07),
            ],
        },
        left {
            mass: 0.05[kg],
            inertia: principal(2e-5, 1.8e-5, 6e-6),
            points: [foot = (0, -0.004, -0.02)],
        },
        right {
            mass: 0.05[kg],
            inertia: principal(2e-5, 1.8e-5, 6e-6),
            points: [foot = (0, 0.013, -0.032)],
        },
        tool {
            mass: 0.2[kg],
            inertia: principal(2e-4, 2.5e-4, 1e-4),
            points: [foot = (-0.01, -0.02, -0.03)],
        },
    ],
    joints: [
        carriage_joint = prismatic(world(0.5, -0.1, 0.2), carriage.foot, body(0, 0, 1))
            .turned(body(0, 0, 1), 180[deg])
            .turned(body(0, 1, 0), 90[deg]),
        turn = revolute(carriage.top, palm.foot, body(0, -1, 0)).turned(body(0, 0, 1), -0.4),
        finger_1 = prismatic(palm.one, left.foot, body(0, 1, 0)),
        finger_2 = weld(palm.two, right.foot).turned(body(0, 0, 1), 0.3),
        tool_tilt = weld(palm.tool, tool.foot)
            .turned(body(0, 1, 0), 0.1)
            .turned(body(1, 0, 0), 0.2)
            .turned(body(0, 0.6, 0.8), tilt),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});

rigid_system!(Quadruped {
    urdf: "tests/urdf/quadruped.urdf",
    inputs: [push[N]],
    bodies: [
        trunk {
            points: [handle = origin + body(0, 0, 0.1)],
            forces: [shove = world(push, 0, 0).at(handle)],
        },
        load {
            mass: 2[kg],
            inertia: sphere(0.1[m])
        },
    ],
    joints: [root = free(base), strap = weld(trunk.handle, load.G)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [cord = (3[N]).between(front_left_foot.origin, hind_right_foot.origin)],
    outputs: [energy, momentum],
});

// links without mass in the file, which get it here
rigid_system!(Sensor {
    urdf: "tests/urdf/sensor.urdf",
    bodies: [
        camera {
            mass: 0.2[kg],
            inertia: principal(1e-4, 2e-4, 1.5e-4)
        },
        lens {
            mass: 0.1[kg],
            inertia: sphere(0.03[m])
        },
    ],
    joints: [glue = weld(plate.origin, lens.G)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});
