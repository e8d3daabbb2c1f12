use newton_euler::rigid_body;

rigid_body!(Stick {
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: scalar(0.1)[kg * m ^ 2],
});

fn main() {}
