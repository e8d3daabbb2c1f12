use newton_euler::prelude::*;

rigid_system!(Pair {
    bodies: [
        a { mass: 1[kg], inertia: sphere(0.1[m]) },
        b { mass: 1[kg], inertia: sphere(0.1[m]) },
    ],
    joints: [first = free(a), second = free(b)],
    outputs: [reactions],
});

fn main() {}
