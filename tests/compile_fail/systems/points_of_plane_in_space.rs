use newton_euler::rigid_system;

// one point forgets an axis: the rest is in space, and has mistakes of its own
rigid_system!(Parts {
    bodies: [
        first { mass: 1[kg], inertia: principal(-1, 1, 1)[kg * m ^ 2] },
        second {
            mass: 1[kg],
            inertia: cylinder(-1[m], 2[m]),
            points: [p = (1, 2)[m], end = (0, 0, 1)[m], end = (0, 0, 2)[m]],
        },
    ],
    joints: [f = free(first), hang = spherical(world(0, 0, 0), second.tip)],
});

fn main() {}
