use newton_euler::rigid_system;

rigid_system!(Pair {
    motion: planar,
    bodies: [
        left { mass: 2[kg], inertia: 1[kg * m ^ 2] },
        right { mass: 2[kg], inertia: 1[kg * m ^ 2] },
    ],
    joints: [rod_x = revolute(world(0, 0), left.G), floating = free(right)],
    constraints: [
        rod = right.G.position() - world(1, 0)[m],
        rod_y = rod_x.angle - floating.angle,
    ],
    outputs: [reactions],
});

// the loads of constraints of two bodies, or of a body and the system
rigid_system!(Discs {
    motion: planar,
    bodies: [
        disc {
            mass: 2[kg],
            inertia: 1[kg * m ^ 2],
            constraints: [left_touches = position.in_world().y, rolling = velocity.in_world().x],
        },
        disc_left {
            mass: 2[kg],
            inertia: 1[kg * m ^ 2],
            constraints: [touches = position.in_world().y],
        },
    ],
    joints: [one = free(disc), other = free(disc_left)],
    constraints: [disc_rolling = one.angle - other.angle],
    outputs: [reactions],
});

fn main() {}
