use newton_euler::rigid_body;

rigid_body!(Wheel {
    motion: pivot(pin),
    inputs: [command[rad / s]],
    states: [speed[rad / s]],
    rates: [speed = (command - speed) / 0.1[s]],
    mass: 2[kg],
    inertia: 1[kg * m ^ 2] + 0.1[kg * m ^ 2 * s] * speed,
    points: [pin = (0, 0.5)],
    moments: [motor = 0.1[N * m * s] * speed],
});

fn main() {}
