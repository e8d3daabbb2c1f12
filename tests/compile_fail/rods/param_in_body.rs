use newton_euler::rigid_body;

rigid_body!(Stick {
    motion: rod(body(1, 0, 0)),
    params: [push = body(1, 0, 0)[N]],
    mass: 2[kg],
    inertia: rod(0.5[m]),
    forces: [pushed = push],
});

fn main() {}
