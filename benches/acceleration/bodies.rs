//! The bodies as they are described.

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
