use newton_euler::rigid_body;

rigid_body!(Door {
    motion: fixed_axis(hinge, world(0, 0, 2)[m]),
    mass: 12[kg],
    inertia: cuboid(0.8, 0.04, 2),
    points: [hinge = (-0.4, 0, 0)],
});

fn main() {}
