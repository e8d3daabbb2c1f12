use newton_euler::rigid_body;

rigid_body!(Tanker {
    motion: spatial,
    states: [fuel[kg]],
    rates: [fuel = -0.1[kg / s]],
    inertia: compose([
        cuboid(1, 2, 3).mass(30[kg]),
        sphere(0.3).mass(fuel).at((0, 0, 0.4)),
    ]),
});

fn main() {}
