use newton_euler::rigid_body;

rigid_body!(Stick {
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: rod(0.5[m]),
    points: [tip = (0.25, 0.1, 0)],
    forces: [push = world(0, 0, 1)[N].at(tip)],
});

fn main() {}
