//! The description of a file with all its values, as `describe` prints it.

use newton_euler::prelude::*;

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
