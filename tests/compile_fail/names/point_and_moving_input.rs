use newton_euler::prelude::*;

rigid_system!(Pair {
    motion: planar,
    inputs: [hook[m].moving],
    locals: [swing = first.angle],
    bodies: [
        a { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [pin = (0.1, 0), hook = (0.2, 0)] },
        b { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [pin = (0.1, 0), swing = (0.2, 0)] },
        c { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [pin = (0.1, 0)] },
    ],
    joints: [
        first = revolute(world(0, 0), a.pin),
        second = revolute(a.hook, b.pin),
        third = revolute(b.swing, c.pin),
    ],
});

rigid_body!(Alone {
    motion: pivot(hook),
    inputs: [hook[m].moving],
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [hook = (0.1, 0)],
});

fn main() {}
