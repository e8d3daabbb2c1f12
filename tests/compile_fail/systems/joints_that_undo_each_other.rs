use newton_euler::prelude::*;

// the direction of `second` is turned about itself, and so is the same
rigid_system!(Hinges {
    bodies: [
        wheel { mass: 1[kg], inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2], points: [hub = (0.1, 0.2, 0.35)] },
        ring { mass: 0 },
    ],
    joints: [
        first = revolute(world(0, 0, 0), ring.G, body(1, 2, 3)),
        second = revolute(ring.G, wheel.hub, body(1, 2, 3)).turned(body(1, 2, 3), 0.3),
    ],
});

rigid_system!(Afloat {
    bodies: [ball { mass: 1[kg], inertia: sphere(0.1) }, cage { mass: 0 }],
    joints: [adrift = free(cage), axle = revolute(cage.G, ball.G, body(1, 0, 0))],
});

// under constraints that do not hold the motion
rigid_system!(Kept {
    motion: planar,
    bodies: [
        arm { mass: 1[kg], inertia: 1[kg * m ^ 2] },
        ring { mass: 0[kg] },
        tip { mass: 1[kg], inertia: 1[kg * m ^ 2] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), arm.G),
        first = revolute(arm.G, ring.G),
        second = revolute(ring.G, tip.G),
    ],
    constraints: [still = shoulder.angle],
});

// in a closed loop that does not
rigid_system!(Closed {
    motion: planar,
    bodies: [
        arm { mass: 1[kg], inertia: 1[kg * m ^ 2] },
        ring { mass: 0[kg] },
        tip { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [o = (1, 0)] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), arm.G),
        first = revolute(arm.G, ring.G),
        second = revolute(ring.G, tip.G),
        guide = prismatic(world(3, 0), tip.o, world(1, 0)),
    ],
});

rigid_system!(Carried {
    bodies: [
        cage { mass: 0[kg] },
        ball { mass: 1[kg], inertia: sphere(0.1[m]), points: [o = (0, 0, 0.1)] },
    ],
    joints: [adrift = free(cage), both = universal(cage.G, ball.o, body(1, 0, 0), body(0, 1, 0))],
    constraints: [plane = ball.o.position().in_world().x - 1[m]],
});

fn main() {}
