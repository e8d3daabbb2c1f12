use newton_euler::rigid_body;

rigid_body!(Pipe {
    motion: spatial,
    params: [inner = 0.3[m], outer = 0.2[m]],
    mass: 2[kg],
    inertia: tube(inner, outer, 1[m]),
});

fn main() {}
