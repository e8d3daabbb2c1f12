use newton_euler::rigid_body;

rigid_body!(Drum {
    motion: spatial,
    mass: 2[kg],
    inertia: cylinder(0.1[m]),
});

// the one that is too many is the token to change
rigid_body!(Mast {
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: rod(1[m], 0.01[m]),
});

fn main() {}
