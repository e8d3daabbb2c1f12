use newton_euler::rigid_body;

rigid_body!(Brick {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 2, 2.5)[kg * m ^ 2].at(p),
    points: [p = (0.1, 0, 0)[m]],
});

fn main() {}
