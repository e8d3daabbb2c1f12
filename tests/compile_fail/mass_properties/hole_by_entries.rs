use newton_euler::rigid_body;

rigid_body!(Drum {
    motion: spatial,
    inertia: compose([sphere(0.1[m]).mass(2[kg]), principal(1, 1, 1).mass(-1[kg])]),
});

fn main() {}
