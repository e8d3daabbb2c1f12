use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    moments: [rudder = -2[N * m] * attitude.yaw() * body(0, 0, 1)],
});

fn main() {}
