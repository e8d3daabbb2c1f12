use newton_euler::rigid_body;

rigid_body!(Stick {
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: rod(0.5[m]),
    points: [tip = (0.25, 0, 0)],
    reactions: [hold = world(0, 0, _).at(tip)],
});

fn main() {}
