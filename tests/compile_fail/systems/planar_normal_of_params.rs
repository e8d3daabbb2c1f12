use newton_euler::rigid_system;

rigid_system!(Table {
    params: [slope],
    bodies: [
        plate { mass: 1[kg], inertia: principal(2, 3, 4)[kg * m ^ 2], points: [p = (0.1, 0, 0)] },
    ],
    joints: [table = planar(world(0, 0, 0), plate.p, body(0, slope, 1))],
});

fn main() {}
