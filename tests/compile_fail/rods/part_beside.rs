use newton_euler::rigid_body;

rigid_body!(Stick {
    motion: rod(body(1, 0, 0)),
    inertia: compose([rod(0.5[m]).mass(1[kg]), point(0.2[kg]).at((0.25, 0.1, 0)),]),
});

fn main() {}
