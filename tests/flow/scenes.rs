//! One body of each kind that has a closed form.

use newton_euler::prelude::*;

rigid_body!(Brick {
    doc: "Three different moments, weight.",
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.01, 0.02, 0.026),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Drum {
    doc: "An axis of symmetry that is no axis of the user's, and an input that nothing depends on.",
    motion: spatial,
    inputs: [_idle],
    mass: 2[kg],
    inertia: cylinder(0.1[m], 0.7[m]).along(body(0, 3, 4)),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [wind = world(0.3, -0.1, 0)[N]],
    outputs: [flow, energy],
});

rigid_body!(Probe::<T> {
    doc: "Generic over its scalar: its closed form is that of `f64`.",
    motion: spatial,
    params: [m = 2[kg]],
    mass: m,
    inertia: principal(0.01, 0.005 * m, 0.013),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Ball {
    doc: "Three equal moments; two forces of which the moments cancel.",
    motion: spatial,
    mass: 2[kg],
    inertia: sphere(0.1[m]),
    points: [left = (0, 1, 0), right = (0, -1, 0)],
    forces: [
        first = world(0, 0, 1)[N].at(left),
        second = world(0, 0, 1)[N].at(right)
    ],
    outputs: [flow],
});

rigid_body!(Tilted {
    doc: "Products of inertia.",
    motion: spatial,
    mass: 2[kg],
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    },
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Loaded {
    doc: "The same, as parameters.",
    motion: spatial,
    params: [
        m = 2[kg],
        xx = 1.3,
        xy = -0.12,
        gravity = world(0, 0, -9.80665)[m / s ^ 2]
    ],
    mass: m,
    inertia: tensor {
        xx: xx,
        yy: 1.7,
        zz: 2.1,
        xy: xy,
        yz: -0.05,
        zx: 0.07
    },
    fields: [weight = mass * gravity],
    outputs: [flow],
});

rigid_body!(Skewed::<T> {
    doc: "The same over any scalar, which keeps no principal axes.",
    motion: rotation,
    params: [xx = 1.3, xy = -0.12],
    inertia: tensor {
        xx: xx,
        yy: 1.7,
        zz: 2.1,
        xy: xy,
        yz: -0.05,
        zx: 0.07
    },
    outputs: [flow],
});

rigid_body!(Handle {
    doc: "Parameters without products.",
    motion: rotation,
    params: [about_x = 1.0, about_y = 2.0],
    inertia: principal(about_x, about_y, about_x + about_y),
    outputs: [flow],
});

rigid_body!(Balanced {
    doc: "Held at G.",
    motion: fixed_point(G),
    mass: 2[kg],
    inertia: principal(2, 1, 1.5),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Slanted {
    doc: "Held beside G, without weight.",
    motion: fixed_point(tip),
    mass: 2[kg],
    inertia: principal(2, 1, 1.5),
    points: [tip = (0.3, 0.2, -0.4)],
    outputs: [flow],
});

rigid_body!(Plank {
    doc: "In the plane, with a constant moment.",
    motion: planar,
    params: [torque = 0.4[N * m]],
    mass: 6[kg],
    inertia: 2[kg * m ^ 2],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    moments: [motor = torque],
    outputs: [flow],
});

rigid_body!(Wheel {
    doc: "A force fixed in the body turns G: but its moment is constant; here it is in balance.",
    motion: planar,
    mass: 6[kg],
    inertia: 2[kg * m ^ 2],
    points: [rim = (0.5, 0)],
    forces: [push = body(0, 3).at(rim), pull = body(0, -3).at(G)],
    outputs: [flow],
});

rigid_body!(Towed {
    doc: "A constant force beside G: a pendulum that is accelerated.",
    motion: planar,
    params: [arm = 0.3[m]],
    mass: 6[kg],
    inertia: 2[kg * m ^ 2],
    points: [hook = (arm, 0.1)],
    forces: [rope = world(4, 1.5)[N].at(hook)],
    outputs: [flow],
});

rigid_body!(Puck {
    doc: "In the plane, without turning.",
    motion: planar_translation,
    mass: 0.2[kg],
    forces: [slope = world(0.1, -0.7)[N]],
    outputs: [flow],
});

rigid_body!(Parcel {
    doc: "In space, without turning.",
    motion: translation,
    mass: 3[kg],
    forces: [crane = body(0, 0, 40)[N]],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Swing {
    doc: "A pendulum.",
    motion: pivot(pin),
    params: [gravity = 9.80665[m / s ^ 2]],
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    points: [pin = (0.2, 0.7)],
    fields: [weight = mass * world(0, -gravity)],
    outputs: [flow],
});

rigid_body!(Door {
    doc: "A door on a leaning frame, with a bearing that is loaded along its axis.",
    motion: fixed_axis(hinge, body(0.1, 0, 1)),
    mass: 20[kg],
    inertia: cuboid(0.9[m], 0.04[m], 2[m]),
    points: [hinge = (-0.45, 0, 0)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Winch {
    doc: "A constant moment.",
    motion: fixed_axis(G, body(1, 2, 2)),
    mass: 2[kg],
    inertia: principal(0.2, 0.3, 0.4),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    moments: [motor = body(0.1, 0.4, 0)],
    outputs: [flow],
});

rigid_body!(Baton {
    doc: "A slender rod.",
    motion: rod(body(1, 0, 0)),
    params: [length = 0.8[m]],
    mass: 0.2[kg],
    inertia: mass * length.powi(2) / 12,
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Top {
    doc: "A heavy symmetric top, held at a point of its axis.",
    motion: fixed_point(tip),
    mass: 2[kg],
    inertia: principal(0.2, 0.2, 0.1),
    points: [tip = (0, 0, -0.1[m])],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [energy, flow],
});

rigid_body!(Gyroscope {
    doc: "The same of parameters, and about another axis.",
    motion: fixed_point(tip),
    params: [
        m = 2[kg],
        across = 0.2,
        along = 0.1,
        arm = 0.1[m],
        gravity = world(0, 0, -9.81)[m / s ^ 2]
    ],
    mass: m,
    inertia: principal(along, across, across),
    points: [tip = (-arm, 0, 0)],
    fields: [weight = mass * gravity],
    outputs: [energy, flow],
});

rigid_body!(Magnet {
    doc: "A couple on an axis of symmetry that is no axis of the user's.",
    motion: rotation,
    mass: 2[kg],
    inertia: cylinder(0.1[m], 0.7[m]).along(body(0, 3, 4)),
    moments: [field = body(0, 0.6, 0.8).cross(world(0.3, -0.2, 0.5))],
    outputs: [flow],
});

rigid_body!(Weighted {
    doc: "A ball that a force pulls beside its center, while it falls.",
    motion: spatial,
    mass: 2[kg],
    inertia: sphere(0.1[m]),
    points: [ear = (0.02, 0.03, -0.06)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [string = world(0.1, 0.4, 1)[N].at(ear)],
    outputs: [flow],
});

rigid_body!(Stage {
    doc: "Spun up about its axis while it falls.",
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.3, 0.3, 0.1),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    moments: [motor = body(0, 0, 0.2)],
    outputs: [flow, taylor],
});

rigid_body!(Pinwheel::<T> {
    doc: "Of parameters, and generic: a pair of jets, about the second axis.",
    motion: rotation,
    params: [across = 0.3, along = 0.5, arm = 0.4[m], thrust = 0.25[N]],
    inertia: principal(across, along, across),
    points: [left = (arm, 0, 0), right = (-arm, 0, 0)],
    forces: [
        first = body(0, 0, thrust).at(left),
        second = body(0, 0, -thrust).at(right)
    ],
    outputs: [flow, taylor],
});

rigid_body!(Drill {
    doc: "An axis of symmetry that is no axis of the user's, held at a point of it.",
    motion: fixed_point(tip),
    mass: 2[kg],
    inertia: cylinder(0.1[m], 0.7[m]).along(body(0, 3, 4)),
    points: [tip = (0, 0.3, 0.4)],
    moments: [motor = body(0, -0.003, -0.004)],
    outputs: [flow],
});

rigid_body!(Sphere {
    doc: "A moment in any direction is along an axis of symmetry; two jets, of which the forces cancel.",
    motion: spatial,
    mass: 2[kg],
    inertia: sphere(0.3[m]),
    points: [left = (0.3, 0, 0), right = (-0.3, 0, 0)],
    forces: [
        first = body(0, 0.1, 0.2)[N].at(left),
        second = body(0, -0.1, -0.2)[N].at(right),
        wind = world(1, 2, 0)[N],
    ],
    moments: [motor = body(0.01, 0, 0)],
    outputs: [flow],
});

rigid_body!(Globe {
    doc: "The same of a parameter.",
    motion: rotation,
    params: [radius = 0.3[m]],
    mass: 2[kg],
    inertia: sphere(radius),
    moments: [motor = body(0.01, 0.02, -0.03)],
    outputs: [flow],
});
