//! The bodies and systems with user-defined states.

use newton_euler::prelude::*;

rigid_body!(Rocket {
    doc: "A motor that lags, and the fuel that it takes.",
    motion: translation,
    params: [lag = 0.05[s], flow = 0.25[kg / N / s]],
    inputs: [command[N]],
    states: [thrust[N], fuel[kg]],
    rates: [thrust = (command - thrust) / lag, fuel = -flow * thrust,],
    mass: 2[kg],
    forces: [engine = body(0, 0, thrust)],
    outputs: [taylor],
});

rigid_body!(Drone::<T> {
    doc: "Two motors, a wing's drag, and all outputs that a body with states of its own can have.",
    motion: spatial,
    params: [lag = 0.08[s], lift = 0.02[N * s / rad], drag = 0.3[kg / s]],
    inputs: [command_1[rad / s], command_2[rad / s]],
    states: [speed_1[rad / s], speed_2[rad / s]],
    rates: [
        speed_1 = (command_1 - speed_1) / lag - 0.1[rad / m / s] * velocity.in_body().z,
        speed_2 = (command_2 - speed_2) / lag - 0.1[rad / m / s] * velocity.in_body().z,
    ],
    mass: 1.3[kg],
    inertia: tensor {
        xx: 0.02,
        yy: 0.03,
        zz: 0.04,
        xy: 0.002,
        yz: -0.001,
        zx: 0.003
    }[kg * m ^ 2],
    points: [left = (0, 0.2, 0.01), right = (0, -0.2, 0.01)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [
        lift_1 = body(0, 0, lift * speed_1).at(left),
        lift_2 = body(0, 0, lift * speed_2).at(right),
        air = -drag * velocity,
    ],
    outputs: [energy, momentum, balance, taylor, linearization],
});

rigid_body!(Servo::<T> {
    doc: "A controller with an integrator holds an arm against its weight.",
    motion: pivot(hinge),
    params: [
        stiffness = 40[N * m],
        damping = 8[N * m * s],
        gain = 60[N * m / s],
        lag = 0.02[s]
    ],
    inputs: [target[rad]],
    states: [integral[rad * s], torque[N * m]],
    rates: [
        integral = lack,
        torque = (stiffness * lack + gain * integral - damping * angular_velocity - torque) / lag,
    ],
    locals: [lack = target - attitude],
    mass: 1.5[kg],
    inertia: 0.08[kg * m ^ 2],
    points: [hinge = (-0.3, 0)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    moments: [motor = torque],
    reactions: [pin = world(_, _).at(hinge)],
    outputs: [energy, reactions, taylor, linearization],
});

rigid_body!(Bead::<T> {
    doc: "A body under a written constraint, and a brake that warms up.",
    motion: planar,
    states: [warmth[J]],
    rates: [warmth = brake_force * velocity.norm_squared()],
    locals: [brake_force = 0.4[kg / s] + 0.001[kg / s / J] * warmth],
    mass: 0.7[kg],
    inertia: 0.01[kg * m ^ 2],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    forces: [brake = -brake_force * velocity],
    constraints: [ring = position.in_world().norm_squared() - 1[m ^ 2]],
    reactions: [wire = _ * position.normalize()],
    outputs: [energy, linearization],
});

rigid_system!(Arms::<T> {
    doc: "Two arms, each with a motor that lags, and the work of both.",
    motion: planar,
    params: [lag_1 = 0.05[s], lag_2 = 0.03[s]],
    inputs: [command_1[N * m], command_2[N * m]],
    states: [torque_1[N * m], torque_2[N * m], work[J]],
    rates: [
        torque_1 = (command_1 - torque_1) / lag_1,
        torque_2 = (command_2 - torque_2) / lag_2,
        work = torque_1 * shoulder.angular_velocity + torque_2 * elbow.angular_velocity,
    ],
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
    drives: [
        motor_1 = torque_1.on(shoulder),
        motor_2 = torque_2.on(elbow)
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [energy, reactions, taylor, linearization, mass_matrix],
});

rigid_system!(FourBar::<T> {
    doc: "A loop that a motor turns.",
    motion: planar,
    states: [torque[N * m]],
    rates: [torque = (2[N * m] - torque) / 0.1[s] - 0.5[N * m / rad] * pivot_1.angular_velocity],
    bodies: [
        crank {
            mass: 0.5[kg],
            inertia: 0.002[kg * m ^ 2],
            points: [a = (-0.1, 0), b = (0.1, 0)]
        },
        rod {
            mass: 1[kg],
            inertia: 0.03[kg * m ^ 2],
            points: [a = (-0.3, 0), b = (0.3, 0)]
        },
        rocker {
            mass: 0.7[kg],
            inertia: 0.01[kg * m ^ 2],
            points: [a = (-0.2, 0), b = (0.2, 0)]
        },
    ],
    joints: [
        pivot_1 = revolute(world(0, 0), crank.a),
        pivot_2 = revolute(crank.b, rod.a),
        pivot_3 = revolute(rod.b, rocker.b),
        pivot_4 = revolute(world(0.6, 0), rocker.a),
    ],
    drives: [motor = torque.on(pivot_1)],
    outputs: [energy, linearization],
});

rigid_system!(Filter::<T> {
    doc: "A bracket that does not move, and a load on it that swings.",
    motion: planar,
    states: [force[N], rate[N / s]],
    rates: [force = rate, rate = -9[1 / s ^ 2] * force],
    bodies: [bracket {
        mass: 1[kg],
        inertia: 0.1[kg * m ^ 2],
        points: [foot = (0, -0.5)[m]]
    }],
    joints: [base = weld(world(0, 0), bracket.foot)],
    moments: [swing = moment(force * 0.2[m]).on(bracket)],
    outputs: [reactions, taylor, linearization],
});
