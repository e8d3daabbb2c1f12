use newton_euler::rigid_body;

rigid_body!(Door {
    motion: fixed_axis(hinge, world.z),
    mass: 1[kg],
    inertia: principal(1, 2, 2.5)[kg * m ^ 2],
    points: [hinge = (0.4, 0, 0)[m]],
});

fn main() {}
