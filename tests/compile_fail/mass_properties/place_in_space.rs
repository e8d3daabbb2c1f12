use newton_euler::rigid_body;

rigid_body!(Drum {
    motion: spatial,
    inertia: compose([sphere(0.1[m]).mass(1[kg]).at(world(0, 0, 1))]),
});

fn main() {}
