use newton_euler::rigid_body;

rigid_body!(Glider {
    motion: spatial,
    inputs: [gust = world(_, _, _)[N], gust_x[N], velocity_z[N]],
    states: [velocity_y[m / s]],
    rates: [velocity_y = 1[m / s ^ 2]],
    mass: 2[kg],
    inertia: sphere(0.1[m]),
    forces: [push = gust + world(gust_x, 0, velocity_z)],
    outputs: [linearization],
});

// in the plane too, `gust_z` would be taken for a component
rigid_body!(Kite {
    motion: planar,
    inputs: [gust = world(_, _)[N], gust_z[N * m]],
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    forces: [push = gust],
    moments: [turn = gust_z],
    outputs: [linearization],
});

fn main() {}
