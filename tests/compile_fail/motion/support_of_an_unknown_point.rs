use newton_euler::rigid_body;

rigid_body!(Door {
    motion: pivot(hinge),
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
});

fn main() {}
