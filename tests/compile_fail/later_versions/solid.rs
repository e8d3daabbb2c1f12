use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 1.2[kg],
    inertia: cuboid(0.1[m], 0.2[m], 0.3[m]),
});

fn main() {}
