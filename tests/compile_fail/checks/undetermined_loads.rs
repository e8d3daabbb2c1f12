use newton_euler::rigid_system;

// the bearings of a shaft hold it twice along their axis
rigid_system!(Shaft {
    bodies: [
        shaft { mass: 2[kg], inertia: principal(1, 1, 0.5)[kg * m ^ 2], points: [a = (0, 0, -0.5), b = (0, 0, 0.5)] },
    ],
    joints: [
        one = revolute(world(0, 0, 0), shaft.a, world(0, 0, 1)),
        two = revolute(world(0, 0, 1), shaft.b, world(0, 0, 1)),
    ],
    checks: [
        half = (two.force.in_world().x == 0[N]).given(one.angle = 0, one.angular_velocity = 0[rad / s]),
        less = (one.moment.norm() < 1).given(one.angle = 0, one.angular_velocity = 0[rad / s]),
    ],
});

fn main() {}
