use newton_euler::rigid_body;

rigid_body!(Brick {
    motion: spatial,
    mass: 1[kg],
    inertia: cuboid { width: 0.1[m], height: 0.2[m], depth: 0.3[m] },
});

fn main() {}
