use newton_euler::rigid_system;

rigid_system!(Table {
    bodies: [
        plate { mass: 1[kg], inertia: principal(2, 3, 4)[kg * m ^ 2] },
    ],
    joints: [cart = translation(plate).turned(body(0, 0, 1), 90[deg])],
});

fn main() {}
