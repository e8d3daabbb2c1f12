use newton_euler::rigid_body;

const MASS: f64 = 2.0;

rigid_body!(Plank {
    motion: planar,
    mass: MASS,
    inertia: 0.3[kg * m ^ 2],
});

fn main() {}
