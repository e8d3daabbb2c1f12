use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    inputs: [thrust: N, turn: kg * m / s],
    states: [fuel:],
    rates: [fuel = 0],
    forces: [push = body(0, thrust)],
});

fn main() {}
