use newton_euler::rigid_system;

rigid_system!(Pinned {
    motion: planar,
    bodies: [arm { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [pin = (-0.2, 0)[m]] }],
    joints: [hinge = revolute(world(0, 0), arm.pin), again = revolute(world(1, 0), arm.pin)],
});

rigid_system!(Skewed {
    bodies: [
        arm { mass: 1[kg], inertia: principal(1, 1, 1)[kg * m ^ 2], points: [pin = (-0.2, 0, 0)[m]] },
        rotor { mass: 1[kg], inertia: principal(1, 1, 1)[kg * m ^ 2] },
    ],
    joints: [
        hinge = revolute(world(0, 0, 0), arm.pin, body(0, 0, 1)),
        spin = revolute(arm.pin, rotor.G, body(0, 0, 1)),
        again = spherical(world(0.2, 0, 0), arm.pin),
    ],
});

rigid_system!(Carried {
    motion: planar,
    bodies: [
        base { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [left = (0, 0), right = (1, 0)[m]] },
        arm { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [pin = (-0.2, 0)[m]] },
    ],
    joints: [
        float = free(base),
        hinge = revolute(base.left, arm.pin),
        again = revolute(base.right, arm.pin),
    ],
});

fn main() {}
