use newton_euler::rigid_body;

rigid_body!(Drum {
    motion: spatial,
    inertia: compose([sphere(0.1[m]).mass(1[kg]), point(1[kg]).mass(1[kg]).at((0.1, 0, 0))]),
});

fn main() {}
