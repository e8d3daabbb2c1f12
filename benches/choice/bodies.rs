//! Bodies that occur in no diagram.

use newton_euler::rigid_body;

rigid_body!(Shell {
    motion: spatial,
    mass: 40[kg],
    inertia: principal(0.3, 0.3, 0.1)[kg * m ^ 2],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [drag = -0.004[kg / m] * velocity.norm() * velocity],
    outputs: [taylor],
});

rigid_body!(Hammock {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.03, 0.02, 0.04)[kg * m ^ 2],
    points: [head = (0.2, 0.1, 0)[m], foot = (-0.2, 0.05, 0.1)[m]],
    potentials: [
        one = 20[N / m] * (head.position() - world(0, 0, 1)[m]).norm_squared(),
        two = 30[N / m] * (foot.position() - world(1, 0, 1)[m]).norm_squared(),
    ],
    outputs: [taylor],
});

rigid_body!(Hung {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.03, 0.02, 0.04)[kg * m ^ 2],
    points: [ring = (0.2, 0.1, 0)[m]],
    potentials: [
        spring = 20[N / m] * ((ring.position() - world(0, 0, 1)[m]).norm() - 0.3[m]).powi(2)
    ],
    outputs: [taylor],
});

rigid_body!(Hovercraft {
    motion: planar,
    mass: 800[kg],
    inertia: 1200[kg * m ^ 2],
    forces: [
        drag = -30[kg / m] * velocity.norm() * velocity,
        push = body(900, 20)[N],
    ],
    moments: [yaw = -500[N * m * s] * angular_velocity],
    outputs: [taylor],
});

rigid_body!(Orbit {
    motion: translation,
    mass: 100[kg],
    potentials: [earth = -3.986004418e14[m ^ 3 / s ^ 2] * mass / G.position().norm()],
    outputs: [taylor],
});

rigid_body!(Shaken {
    motion: rotation,
    inertia: principal(2, 3, 4)[kg * m ^ 2],
    moments: [shaker = body(0.3 * (t / 1[s]).sin(), 0.2, -0.1)[N * m]],
    outputs: [taylor],
});

rigid_body!(Damped {
    motion: rotation,
    inertia: principal(2, 3, 4)[kg * m ^ 2],
    moments: [damping = -0.2[N * m * s ^ 2] * angular_velocity.norm() * angular_velocity],
    outputs: [taylor],
});

rigid_body!(Glider {
    motion: spatial,
    mass: 5[kg],
    inertia: principal(0.3, 0.4, 0.6)[kg * m ^ 2],
    locals: [
        ahead = velocity.dot(body(1, 0, 0)),
        up = velocity.dot(body(0, 0, 1)),
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [air = body(
        -0.02[kg / m] * ahead.powi(2),
        0,
        0.1[kg / m] * ahead.powi(2) - 0.5[kg / m] * ahead * up
    )],
    moments: [damping = -0.3[N * m * s] * angular_velocity],
    outputs: [taylor],
});
