use newton_euler::rigid_system;

rigid_system!(Door {
    motion: planar,
    bodies: [leaf { mass: 2[kg], inertia: 1[kg * m ^ 2], points: [hinge = (-1, 0)[m]] }],
    joints: [swing = revolute(ground, leaf.hinge)],
});

fn main() {}
