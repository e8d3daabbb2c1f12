use newton_euler::{rigid_body, rigid_system};

rigid_system!(OnRail {
    bodies: [cart { mass: 2[kg], inertia: 0 }],
    joints: [rail = prismatic(world(0, 0, 0), cart.G, body(1, 0, 0))],
});

rigid_system!(InAPlane {
    motion: planar,
    bodies: [cart { mass: 2[kg], inertia: 0[kg * m ^ 2] }],
    joints: [rail = prismatic(world(0, 0), cart.G, body(1, 0))],
});

rigid_system!(Loose {
    bodies: [stone { mass: 2[kg], inertia: 0 }],
    joints: [orbit = free(stone)],
});

rigid_system!(OnABall {
    bodies: [bob { mass: 2[kg], inertia: principal(0, 0, 0), points: [p = (1, 0, 0)] }],
    joints: [ball = spherical(world(0, 0, 0), bob.p)],
});

rigid_system!(OnACross {
    bodies: [bob { mass: 2[kg], inertia: principal(0, 0, 0), points: [p = (0, 0, 1)] }],
    joints: [cross = universal(world(0, 0, 0), bob.p, body(1, 0, 0), body(0, 1, 0))],
});

rigid_system!(OnAHinge {
    bodies: [bob { mass: 2[kg], inertia: 0, points: [p = (0, 0, 1)] }],
    joints: [pin = revolute(world(0, 0, 0), bob.p, body(1, 0, 0))],
});

rigid_body!(Turning {
    motion: rotation,
    inertia: principal(0, 0, 0)[kg * m ^ 2],
});

fn main() {}
