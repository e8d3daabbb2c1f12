use newton_euler::rigid_body;

rigid_body!(Rock {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(1, 2, 3)[kg * m ^ 2],
    forces: [push = body(0, 0, 30.to_radians().sin())],
});

fn main() {}
