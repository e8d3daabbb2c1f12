use newton_euler::rigid_body;

rigid_body!(Stick {
    motion: rod(body(1, 0, 0)),
    inputs: [k],
    mass: 2[kg],
    inertia: rod(0.5[m]),
    moments: [twist = (k.powi(3).cbrt() - k.powi(2).powf(0.5)) * axis],
});

fn main() {}
