use newton_euler::rigid_body;

rigid_body!(Drum {
    motion: spatial,
    inertia: compose([sphere(0.1[m]).mass(2[kg]), point(1[kg]).at(G)]),
});

fn main() {}
