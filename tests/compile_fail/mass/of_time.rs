use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: translation,
    mass: 50[kg] - 1.5[kg / s] * t,
    outputs: [energy, momentum],
});

rigid_body!(Still {
    motion: rotation,
    states: [fuel[kg]],
    rates: [fuel = -0.1[kg / s]],
    inertia: principal(1, 2, 2.5 * fuel / 1[kg])[kg * m ^ 2],
    outputs: [flow],
});

fn main() {}
