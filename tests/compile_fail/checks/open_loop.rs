use newton_euler::{rigid_body, rigid_system};

// a square at 90, -90, -90 degrees
rigid_system!(Square {
    motion: planar,
    bodies: [
        a { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [h = (-1, 0)[m], e = (1, 0)[m]] },
        b { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [h = (-1, 0)[m], e = (1, 0)[m]] },
        c { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [h = (-1, 0)[m], e = (1, 0)[m]] },
    ],
    joints: [
        j1 = revolute(world(0, 0), a.h),
        j2 = revolute(a.e, b.h),
        j3 = revolute(b.e, c.h),
        j4 = revolute(world(2, 0)[m], c.e),
    ],
    checks: [
        open = (j1.angular_acceleration == 0).given(
            j1.angle = 80[deg], j2.angle = -90[deg], j3.angle = -90[deg],
            j1.angular_velocity = 0, j2.angular_velocity = 0, j3.angular_velocity = 0,
        ),
        moving_apart = (j1.angular_acceleration == 0).given(
            j1.angle = 90[deg], j2.angle = -90[deg], j3.angle = -90[deg],
            j1.angular_velocity = 1, j2.angular_velocity = 0, j3.angular_velocity = 0,
        ),
        // these hold: the second state is given with four digits
        closed = (j1.angular_acceleration == 0).given(
            j1.angle = 90[deg], j2.angle = -90[deg], j3.angle = -90[deg],
            j1.angular_velocity = 0, j2.angular_velocity = 0, j3.angular_velocity = 0,
        ),
        rounded = (j1.angular_acceleration < 1e-3).given(
            j1.angle = 1.571, j2.angle = -1.571, j3.angle = -1.571,
            j1.angular_velocity = 0, j2.angular_velocity = 0, j3.angular_velocity = 0,
        ),
    ],
});

rigid_body!(Bead {
    motion: translation,
    mass: 1[kg],
    constraints: [wire = position.in_world().z - position.in_world().x],
    reactions: [push = _ * wire.gradient()],
    checks: [beside = (acceleration.in_world().y == 0).given(position = world(1, 0, 0.9), velocity = world(0, 0, 0))],
});

// the slider is reversed in the last state
rigid_system!(Slider {
    motion: planar,
    bodies: [
        crank { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [e = (0.1, 0)[m]] },
        rod { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [e = (0.3, 0)[m]] },
        slider { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [q = (0.1, 0)[m]] },
    ],
    joints: [
        a = revolute(world(0, 0), crank.G),
        b = revolute(crank.e, rod.G),
        c = revolute(rod.e, slider.q),
        d = prismatic(world(0, 0), slider.q, world(1, 0)),
    ],
    checks: [
        stretched = (slider.G.position().in_world().x == 0.3[m]).given(
            a.angle = 0, b.angle = 0, c.angle = 0,
            a.angular_velocity = 0, b.angular_velocity = 0, c.angular_velocity = 0,
        ),
        reversed = (slider.G.position().in_world().x == 0.5[m]).given(
            a.angle = 0, b.angle = 0, c.angle = 180[deg],
            a.angular_velocity = 0, b.angular_velocity = 0, c.angular_velocity = 0,
        ),
    ],
});

fn main() {}
