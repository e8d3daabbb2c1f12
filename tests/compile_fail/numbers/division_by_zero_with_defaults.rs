use newton_euler::prelude::*;

// its hinges are at one point
rigid_body!(Door {
    motion: fixed_axis(lower, world(0, 0, 1)),
    params: [span = 0[m]],
    mass: 12[kg],
    inertia: cuboid(0.8, 0.04, 2),
    points: [lower = (-0.4, 0, 0), upper = (-0.4, 0, span)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    reactions: [bearing = world(_, _, _).at(lower), guide = world(_, _, 0).at(upper)],
    outputs: [reactions],
});

// its load carries all of its mass, with a parameter for one of them and for both
rigid_body!(Carried {
    motion: planar_translation,
    params: [k = 2[kg]],
    mass: 2[kg],
    forces: [f = k * acceleration + world(1[N], 0)],
});

rigid_body!(Loaded {
    motion: planar_translation,
    params: [k = 2[kg], load = 2[kg]],
    mass: load,
    forces: [f = k * acceleration + world(1[N], 0)],
});

// each body carries the other
rigid_system!(Two {
    motion: planar,
    params: [k = 1[kg]],
    bodies: [
        a { mass: 1[kg], forces: [pull = k * b.G.acceleration()] },
        b { mass: 1[kg], forces: [push = k * a.G.acceleration()] },
    ],
    joints: [
        one = prismatic(world(0, 0), a.G, world(1, 0)),
        two = prismatic(world(0, 0), b.G, world(1, 0)),
    ],
    fields: [weight = mass * world(1[m / s ^ 2], 0)],
});

fn main() {}
