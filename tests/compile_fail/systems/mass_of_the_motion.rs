use newton_euler::rigid_system;

rigid_system!(Pair {
    bodies: [
        one { mass: 1[kg], inertia: principal(1, 1, 1)[kg * m ^ 2] },
        two { mass: 1[kg] * (1 + slide.position / 1[m]), inertia: principal(1, 1, 1)[kg * m ^ 2] },
    ],
    joints: [
        rail = prismatic(world(0, 0, 0), one.G, world(0, 0, 1)),
        slide = prismatic(one.G, two.G, body(0, 0, 1)),
    ],
});

fn main() {}
