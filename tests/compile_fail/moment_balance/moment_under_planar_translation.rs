use newton_euler::rigid_body;

rigid_body!(Crate {
    motion: planar_translation,
    mass: 10[kg],
    moments: [twist = 2[N * m]],
});

fn main() {}
