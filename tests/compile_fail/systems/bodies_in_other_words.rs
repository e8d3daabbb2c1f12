use newton_euler::rigid_system;

rigid_system!(Chain {
    bodies: [
        Body first { mass: 1[kg], inertia: sphere(0.1[m]) },
        Body { name: second, mass: 1[kg], inertia: sphere(0.1[m]) },
        { name: third, mass: 1[kg], inertia: sphere(0.1[m]) },
        fourth: [mass: 1[kg], inertia: sphere(0.1[m])],
        fifth = body(mass: 1[kg], inertia: sphere(0.1[m])),
    ],
    joints: [
        one = free(first),
        two = spherical(first.G, second.G),
        three = spherical(second.G, third.G),
        four = spherical(third.G, fourth.G),
        five = spherical(fourth.G, fifth.G),
    ],
});

fn main() {}
