use newton_euler::rigid_system;

// no load depends on an acceleration

rigid_system!(Fallen {
    motion: planar,
    bodies: [arm {
        mass: 1[kg],
        inertia: 0.1[kg * m ^ 2],
        points: [pin = (1, 0)]
    }],
    joints: [hinge = revolute(world(0, 0), arm.pin)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    checks: [rest = (arm.acceleration.in_world().y == 0[m / s ^ 2])
        .given(hinge.angle = 0, hinge.angular_velocity = 0[rad / s])],
});

rigid_system!(Roped {
    motion: planar,
    bodies: [load {
        mass: 1[kg],
        inertia: 0.1[kg * m ^ 2]
    }],
    joints: [
        flight = free(load),
        rope = cable(
            world(0, 0),
            load.G,
            1[m] + 0.1[s ^ 2] * load.acceleration.in_world().x,
            50[N / m]
        ),
    ],
});

rigid_system!(Heavier {
    motion: planar,
    bodies: [load {
        mass: 1[kg] + 0.1[kg * s ^ 2 / m] * acceleration.in_body().x,
        inertia: 0.1[kg * m ^ 2] + 0.1[kg * m ^ 2 * s ^ 2] * angular_acceleration,
    }],
    joints: [flight = free(load)],
});

rigid_system!(Charged {
    motion: planar,
    bodies: [load {
        mass: 1[kg],
        inertia: 0.1[kg * m ^ 2],
        points: [tip = (0.1, 0)],
        fields: [own = world(1[N / C], 0).on([(1[C] + 0.2[C * s ^ 2 / m] * acceleration.in_body().x).at(tip)])],
    }],
    joints: [flight = free(load)],
});

fn main() {}
