use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: spatial,
    mass: 12[kg],
    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
    moments: [drag = -0.5[kg * m * s ^ 2] * acceleration.in_body().x * angular_acceleration],
});

fn main() {}
