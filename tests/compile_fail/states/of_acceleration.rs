use newton_euler::rigid_body;

rigid_body!(Wheel {
    motion: planar,
    states: [felt[m / s ^ 2]],
    rates: [felt = (acceleration.in_world().x - felt) / 0.1[s]],
    mass: 2[kg],
    inertia: 1[kg * m ^ 2],
    forces: [push = world(2[kg] * felt, 0)],
});

fn main() {}
