use newton_euler::rigid_body;

rigid_body!(Wheel {
    motion: pivot(pin),
    inputs: [command[rad / s]],
    states: [speed[rad / s]],
    rates: [speed = (command - speed) / 0.1[s] + support.norm() * 1[1 / N / s ^ 2]],
    mass: 2[kg],
    inertia: 1[kg * m ^ 2],
    points: [pin = (0, 0.5)],
    moments: [motor = 0.1[N * m * s] * speed],
    reactions: [support = world(_, _).at(pin)],
});

fn main() {}
