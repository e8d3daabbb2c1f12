use newton_euler::rigid_system;

rigid_system!(Heated {
    motion: planar,
    states: [heat[K]],
    rates: [heat = -0.1[1 / s] * heat],
    bodies: [slab { mass: 1[kg], inertia: 1[kg * m ^ 2] }],
    joints: [flight = free(slab)],
    outputs: [flow],
});

fn main() {}
