use newton_euler::rigid_system;

rigid_system!(Table {
    bodies: [
        plate { mass: 1[kg], inertia: principal(2, 3, 4)[kg * m ^ 2], points: [p = (0.1, 0, 0)] },
    ],
    joints: [link = link(world(0, 0, 0), plate.p, 2[m])],
});

fn main() {}
