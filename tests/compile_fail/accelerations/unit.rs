use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: spatial,
    mass: 12[kg],
    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
    forces: [added = -0.5 * acceleration, lift = -2[kg] * angular_acceleration],
});

fn main() {}
