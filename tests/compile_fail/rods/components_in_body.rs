use newton_euler::rigid_body;

rigid_body!(Stick {
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: rod(0.5[m]),
    forces: [drag = world(0, 0, -velocity.in_body().x)],
});

fn main() {}
