use newton_euler::rigid_body;

rigid_body!(Drum {
    motion: spatial,
    inertia: compose([cylinder(0.1[m], 0.4[m]).mass(2[kg]).mass(3[kg])]),
});

fn main() {}
