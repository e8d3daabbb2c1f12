use newton_euler::rigid_body;

rigid_body!(Stick {
    motion: spatial,
    mass: 2[kg],
    inertia: rod(1[m]),
});

fn main() {}
