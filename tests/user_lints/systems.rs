//! Systems, in modules without imports.

/// In space.
pub mod spatial {
    ::newton_euler::rigid_system!(Satellite {
        doc: "A satellite.",
        params: [m = 2.5[kg], J, reach = 0.3[m]],
        inputs: [torque_x[N * m], torque_y[N * m], torque_z[N * m]],
        bodies: [
            hub {
                mass: m,
                inertia: principal(0.3, 0.35, 0.25)[kg * m ^ 2],
                points: [P = (reach, 0.1, 0), Q = (0, reach, 0)],
                forces: [jet = body(0, 0, 0.1)[N].at(P)],
            },
            wheel {
                copies: [x = body(1, 0, 0), y = body(0, 1, 0)],
                mass: 0.4[kg],
                inertia: disc(0.1[m]),
            },
            Boom {
                mass: 0.5[kg],
                inertia: principal(J, J, J),
                points: [root = (0, 0, 0.3)]
            },
            tip {
                mass: 0.1[kg],
                inertia: principal(0.01, 0.01, 0.01)[kg * m ^ 2]
            },
        ],
        joints: [
            orbit = free(hub),
            spin_x = revolute(hub.P, wheel_x.G, body(1, 0, 0)),
            spin_y = revolute(hub.Q, wheel_y.G, body(0, 1, 0)),
            R = spherical(hub.Q, Boom.root),
            glue = weld(Boom.G, tip.G),
        ],
        drives: [
            motor_x = torque_x.on(spin_x),
            motor_y = torque_y.on(spin_y),
            D = (-0.1[N * m * s] * R.angular_velocity).on(R),
        ],
        locals: [L = torque_z * spin_x.angle],
        moments: [M = moment(hub.body(0, 0, L)).on(Boom)],
        forces: [spring = (2[N]).between(hub.P, Boom.G)],
        outputs: [
            linearization,
            sensitivity,
            regressor,
            energy,
            momentum,
            reactions
        ],
    });
}

/// In the plane.
pub mod planar {
    ::newton_euler::rigid_system!(Arm {
        motion: planar,
        bodies: [
            arm_1 {
                mass: 1[kg],
                inertia: 0.1[kg * m ^ 2],
                points: [p = (-0.4, 0), q = (0.4, 0)]
            },
            arm_2 {
                mass: 1[kg],
                inertia: 0.1[kg * m ^ 2],
                points: [p = (-0.4, 0)]
            },
        ],
        joints: [
            arm_a = revolute(world(0, 0), arm_1.p),
            arm_B = prismatic(arm_1.q, arm_2.p, body(1, 0)),
        ],
        fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
        drives: [motor_1 = _.on(arm_a), motor_2 = _.on(arm_B)],
        outputs: [linearization, inverse, reactions, energy, momentum],
    });
}

/// Of any scalar.
pub mod generic {
    ::newton_euler::rigid_system!(Pair::<T> {
        params: [k = 3[N / m]],
        bodies: [
            A {
                mass: 1[kg],
                inertia: principal(0.1, 0.2, 0.15)[kg * m ^ 2],
                points: [p = (0.4, 0, 0)]
            },
            B {
                mass: 1[kg],
                inertia: principal(0.1, 0.2, 0.15)[kg * m ^ 2],
                points: [p = (-0.4, 0, 0)]
            },
        ],
        joints: [base = free(A), rail = cylindrical(A.p, B.p, body(1, 0, 0))],
        drives: [spring = (-k * rail.position).on(rail.position)],
        outputs: [linearization, reactions, energy, momentum],
    });
}

/// What does not move by itself.
pub mod still {
    ::newton_euler::rigid_system!(Boom::<Real> {
        doc: "A boom that turns as it is told.",
        params: [m = 2.5[kg], speed[rad / s]],
        inputs: [wind[N]],
        bodies: [
            mast {
                mass: 2 * m,
                inertia: principal(3, 3, 1)[kg * m ^ 2],
                points: [top = (0, 0, 2)[m]],
                forces: [push = world(wind, 0, 0).at(top)],
            },
            jib {
                mass: m,
                inertia: principal(1, 3, 3)[kg * m ^ 2],
                points: [root = (-1, 0, 0)[m]],
            },
        ],
        joints: [
            foot = weld(world(0, 0, 0), mast.G),
            slew = revolute(mast.top, jib.root, body(0, 0, 1)).driven(speed * t),
        ],
        fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
        outputs: [energy, momentum, reactions, balance],
    });

    ::newton_euler::rigid_system!(Shelf {
        doc: "A shelf.",
        motion: planar,
        bodies: [board {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2],
            points: [end = (-1, 0)[m]],
        },],
        joints: [wall = weld(world(0, 0), board.end)],
        fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
        outputs: [reactions, energy],
    });

    ::newton_euler::rigid_system!(Crank::<R> {
        doc: "A crank with a motor that lags.",
        motion: planar,
        params: [lag = 0.1[s]],
        inputs: [command[N * m]],
        states: [torque_1[N * m], Heat[J], torque_2],
        rates: [
            torque_1 = (command - torque_1) / lag,
            Heat = 0.1[W] * torque_2,
            torque_2 = 0.5[1 / s] * torque_2
        ],
        bodies: [arm {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2],
            points: [end = (-1, 0)[m]],
        },],
        joints: [wall = revolute(world(0, 0), arm.end)],
        drives: [motor = torque_1.on(wall)],
        outputs: [energy, reactions, taylor, linearization],
    });

    ::newton_euler::rigid_body!(Bicycle {
        doc: "A body with states of its own.",
        motion: planar,
        inputs: [steer[rad]],
        states: [steer_1[rad], steer_2[rad]],
        rates: [
            steer_1 = (steer - steer_1) / 0.1[s],
            steer_2 = -steer_2 / 1[s]
        ],
        mass: 1[kg],
        inertia: 1[kg * m ^ 2],
        forces: [side = body(0, steer_1 * 2[N] - steer_2 * 1[N])],
        outputs: [energy, momentum, balance, taylor, linearization],
    });
}

/// From a file, with names that are taken by the language, and inputs that move nothing.
pub mod named {
    ::newton_euler::rigid_system!(Named {
        doc: "A system from a file.",
        mjcf: "tests/user_lints/named.xml",
        outputs: [energy, reactions, taylor, linearization],
    });
}
