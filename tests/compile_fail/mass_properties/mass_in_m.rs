use newton_euler::rigid_body;

rigid_body!(Drum {
    motion: spatial,
    inertia: compose([sphere(0.1[m]).mass(1[m])]),
});

fn main() {}
