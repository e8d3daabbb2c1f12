use newton_euler::rigid_body;

rigid_body!(Lever {
    motion: pivot(pin),
    mass: 3[kg],
    inertia: 0.2[kg * m ^ 2],
    points: [pin = (0, 0.5), tip = (0, -0.7)],
    forces: [hoist = world(0, _).at(tip)],
    moments: [motor = _],
    outputs: [inverse],
});

fn main() {}
