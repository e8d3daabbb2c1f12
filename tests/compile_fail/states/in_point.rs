use newton_euler::rigid_body;

rigid_body!(Wheel {
    motion: planar,
    inputs: [command[rad / s], hook = world(_, _)[m]],
    states: [speed[rad / s]],
    rates: [speed = (command - speed) / 0.1[s]],
    mass: 2[kg],
    inertia: 1[kg * m ^ 2],
    points: [
        tip = (0.1[m * s] * speed, 0),
        moved = G + body(0.1[m * s] * speed, 0),
    ],
    forces: [
        push = world(1, 0).at(tip),
        pull = world(1, 0).at(hook),
        lift = world(0, 1).at(moved),
        drag = world(0, 1).at(G + (hook - position)),
    ],
});

fn main() {}
