use newton_euler::rigid_body;

rigid_body!(Wire {
    motion: spatial,
    mass: 0.1[kg],
    inertia: cylinder(1[um], 1[m]).along(body(1, 2, 2)),
});

fn main() {}
