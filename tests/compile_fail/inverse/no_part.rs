use newton_euler::rigid_body;

rigid_body!(Lever {
    motion: pivot(pin),
    mass: 3[kg],
    inertia: 0.2[kg * m ^ 2],
    points: [pin = (0, 0.5)],
    forces: [hoist = world(0, _).at(pin)],
    outputs: [inverse],
});

fn main() {}
