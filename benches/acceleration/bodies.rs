//! The descriptions of the bodies.

use newton_euler::rigid_body;

rigid_body!(General::<T> {
    doc: "A full inertia tensor, a force at a point of the body, and weight.",
    motion: spatial,
    inputs: [force = body(_, _, _)[N]],
    mass: 3.2[kg],
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    points: [nozzle = (0.1, -0.2, 0.05)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [thrust = force.at(nozzle)],
});

rigid_body!(Principal {
    doc: "The same with principal axes.",
    motion: spatial,
    inputs: [force = body(_, _, _)[N]],
    mass: 3.2[kg],
    inertia: principal(1.3, 1.7, 2.1)[kg * m ^ 2],
    points: [nozzle = (0.1, -0.2, 0.05)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [thrust = force.at(nozzle)],
});

rigid_body!(Plane {
    doc: "The same in the plane.",
    motion: planar,
    inputs: [force = body(_, _)[N]],
    mass: 3.2[kg],
    inertia: 2.1[kg * m ^ 2],
    points: [nozzle = (0.1, -0.2)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [thrust = force.at(nozzle)],
});

rigid_body!(Upright {
    doc: "A body in the plane whose loads do not turn with it.",
    motion: planar,
    inputs: [force = world(_, _)[N], moment[N * m]],
    mass: 3.2[kg],
    inertia: 2.1[kg * m ^ 2],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [push = force],
    moments: [twist = moment],
});

rigid_body!(Free {
    doc: "The general body without loads, of which only the rotation is asked for.",
    motion: rotation,
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
});

rigid_body!(FreePrincipal {
    doc: "The same with principal axes.",
    motion: rotation,
    inertia: principal(1.3, 1.7, 2.1)[kg * m ^ 2],
});

rigid_body!(Crazyflie {
    doc: "The Crazyflie 2.0; rotors 1 and 3 spin about +z.",
    motion: spatial,
    params: [torque_per_thrust = 0.005964552[m]],
    inputs: [thrust_1[N], thrust_2[N], thrust_3[N], thrust_4[N]],
    mass: 0.028[kg],
    inertia: tensor {
        xx: 1.657171e-5[kg * m ^ 2],
        yy: 1.6655602e-5[kg * m ^ 2],
        zz: 2.9261652e-5[kg * m ^ 2],
        xy: 8.30806e-7[kg * m ^ 2],
        yz: 1.800197e-6[kg * m ^ 2],
        zx: 7.18277e-7[kg * m ^ 2],
    },
    points: [
        front_right = (28.243, -28.325, 0)[mm],
        back_right = (-28.243, -28.325, 0)[mm],
        back_left = (-28.243, 28.325, 0)[mm],
        front_left = (28.243, 28.325, 0)[mm],
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        lift_1 = body(0, 0, thrust_1).at(front_right),
        lift_2 = body(0, 0, thrust_2).at(back_right),
        lift_3 = body(0, 0, thrust_3).at(back_left),
        lift_4 = body(0, 0, thrust_4).at(front_left),
    ],
    locals: [twist = thrust_2 + thrust_4 - thrust_1 - thrust_3],
    moments: [drag = body(0, 0, torque_per_thrust * twist)],
    outputs: [linearization],
});
