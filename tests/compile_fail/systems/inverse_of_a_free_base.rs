use newton_euler::rigid_system;

rigid_system!(Satellite {
    bodies: [
        hub { mass: 120[kg], inertia: principal(12, 14, 9)[kg * m ^ 2] },
        wheel { mass: 4[kg], inertia: disc(0.13[m]) },
        boom { mass: 4[kg], inertia: principal(1, 2, 2)[kg * m ^ 2] },
        tip { mass: 4[kg], inertia: principal(1, 2, 2)[kg * m ^ 2] },
    ],
    joints: [
        orbit = free(hub),
        spin = revolute(hub.G, wheel.G, body(0, 0, 1)),
        gimbal = universal(hub.G, boom.G, body(1, 0, 0), body(0, 1, 0)),
        ball = spherical(boom.G, tip.G),
    ],
    drives: [push = _.on(orbit.position), motor = _.on(gimbal.angle_2)],
    outputs: [inverse],
});

fn main() {}
