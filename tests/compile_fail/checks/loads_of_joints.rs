use newton_euler::rigid_system;

rigid_system!(Shaft {
    bodies: [
        shaft { mass: 2[kg], inertia: principal(1, 1, 0.5)[kg * m ^ 2], points: [a = (0, 0, -0.5), b = (0, 0, 0.5)] },
        weight { mass: 1[kg], inertia: principal(1, 1, 1)[kg * m ^ 2] },
    ],
    joints: [
        one = revolute(world(0, 0, 0), shaft.a, world(0, 0, 1)),
        two = revolute(world(0, 0, 1), shaft.b, world(0, 0, 1)),
        loose = free(weight),
    ],
    checks: [
        none = (loose.force.in_world().x == 0[N]),
        given = (one.angle == 0).given(one.force = world(0, 0, 1)[N], one.angle = 0),
    ],
});

fn main() {}
