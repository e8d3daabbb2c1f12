use newton_euler::rigid_system;

rigid_system!(Table {
    bodies: [
        plate { mass: 1[kg], inertia: principal(2, 3, 4)[kg * m ^ 2] },
    ],
    joints: [table = planar_translation(plate)],
});

fn main() {}
