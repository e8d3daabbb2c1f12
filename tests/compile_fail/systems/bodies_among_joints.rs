use newton_euler::rigid_system;

rigid_system!(Pair {
    bodies: [first { mass: 1[kg], inertia: sphere(0.1[m]) }, orbit = free(first)],
    joints: [
        second { mass: 1[kg], inertia: sphere(0.1[m]) },
        ball = spherical(first.G, second.G),
    ],
});

fn main() {}
