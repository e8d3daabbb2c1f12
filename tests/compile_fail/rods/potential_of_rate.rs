use newton_euler::rigid_body;

rigid_body!(Stick {
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: rod(0.5[m]),
    potentials: [u = 1[kg * m ^ 2] * axis_rate.norm_squared()],
});

fn main() {}
