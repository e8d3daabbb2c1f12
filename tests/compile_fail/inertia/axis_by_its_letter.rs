use newton_euler::rigid_body;

rigid_body!(Brick {
    motion: spatial,
    mass: 1[kg],
    inertia: cylinder(0.1[m], 0.2[m]).along(x),
});

fn main() {}
