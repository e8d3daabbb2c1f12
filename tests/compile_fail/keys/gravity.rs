use newton_euler::rigid_body;

rigid_body!(Rock {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(1, 2, 3)[kg * m ^ 2],
    gravity: (0, 0, -9.81),
});

fn main() {}
