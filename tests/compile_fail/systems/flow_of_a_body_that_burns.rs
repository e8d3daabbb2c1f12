use newton_euler::rigid_system;

rigid_system!(Stages {
    motion: planar,
    bodies: [
        stage { mass: 5[kg] - 0.1[kg / s] * t, inertia: 1[kg * m ^ 2] },
        stone { mass: 1[kg], inertia: 1[kg * m ^ 2] },
    ],
    joints: [ascent = free(stage), flight = free(stone)],
    outputs: [flow],
});

fn main() {}
