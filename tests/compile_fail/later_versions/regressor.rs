use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    outputs: [energy, regressor],
});

fn main() {}
