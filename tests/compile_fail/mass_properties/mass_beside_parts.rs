use newton_euler::rigid_body;

rigid_body!(Drum {
    motion: spatial,
    mass: 2[kg],
    inertia: compose([cylinder(0.1[m], 0.4[m]).mass(2[kg])]),
});

fn main() {}
