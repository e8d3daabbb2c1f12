use newton_euler::rigid_body;

rigid_body!(Drum {
    motion: spatial,
    inertia: compose([cylinder(0.1[m], 0.4[m]), point(1[kg]).at((0.1, 0, 0))]),
});

fn main() {}
