use newton_euler::rigid_body;

rigid_body!(Disc {
    motion: planar,
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    outputs: [mass_matrix, jacobian],
});

fn main() {}
