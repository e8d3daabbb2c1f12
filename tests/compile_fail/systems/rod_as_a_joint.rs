use newton_euler::rigid_system;

rigid_system!(Table {
    bodies: [
        plate { mass: 1[kg], inertia: principal(2, 3, 4)[kg * m ^ 2] },
    ],
    joints: [table = rod(plate, body(1, 0, 0))],
});

fn main() {}
