use newton_euler::rigid_system;

rigid_system!(Pair {
    inputs: [push[N]],
    bodies: [
        a { mass: 8[kg], inertia: principal(0.3, 0.3, 0.3), forces: [first = push * world(1, 0, 0)] },
        b { mass: 8[kg], inertia: principal(0.3, 0.3, 0.3), forces: [second = push * world(1, 0, 0)] },
    ],
    joints: [left = free(a), right = free(b)],
    outputs: [flow],
});

fn main() {}
