//! The description of a file with all its values, as `describe` prints it.

use newton_euler::prelude::*;

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
