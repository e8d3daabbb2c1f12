use newton_euler::rigid_system;

rigid_system!(Satellite {
    bodies: [
        hub { mass: 120[kg], inertia: principal(12, 14, 9)[kg * m ^ 2], points: [p = (0.3, 0, 0)] },
        wheel {
            copies: [x = body(1, 0, 0), y = body(0, 0, 0), z = body(0, nonsense, 1)],
            mass: 4[m],
            inertia: disc(0.13[kg]),
            forces: [push = 2[N]],
        },
    ],
    joints: [
        orbit = free(hub),
        spin_x = revolute(hub.p, wheel_x.G, body(1, 0, 0)),
        spin_y = revolute(hub.p, wheel_y.G, body(0, 1, 0)),
        spin_z = revolute(hub.p, wheel_z.G, body(0, 0, 1)),
    ],
});

fn main() {}
