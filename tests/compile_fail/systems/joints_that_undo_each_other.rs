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

fn main() {}
