use newton_euler::rigid_body;

rigid_body!(Pipe {
    motion: spatial,
    mass: 2[kg],
    inertia: tube(0.3[m], 0.2[m], 1[m]),
});

fn main() {}
