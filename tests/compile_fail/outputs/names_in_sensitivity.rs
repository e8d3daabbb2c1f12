use newton_euler::prelude::*;

rigid_body!(Kite {
    motion: spatial,
    params: [wind = world(1, 0, 0)[N], wind_x[N]],
    mass: 1[kg],
    inertia: sphere(0.1[m]),
    forces: [pull = wind + world(wind_x, 0, 0)],
    outputs: [sensitivity],
});

fn main() {}
