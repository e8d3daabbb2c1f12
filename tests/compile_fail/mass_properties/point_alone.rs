use newton_euler::rigid_body;

rigid_body!(Bob {
    motion: spatial,
    mass: 2[kg],
    inertia: point(2[kg]),
});

fn main() {}
