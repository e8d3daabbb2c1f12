use newton_euler::rigid_system;

rigid_system!(Arm {
    motion: planar,
    inputs: [command[N * m]],
    states: [turn[rad]],
    rates: [turn = command / 1[N * m * s]],
    bodies: [arm { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [hinge = (-0.3, 0)[m]] }],
    joints: [shoulder = revolute(world(0, 0), arm.hinge).driven(turn)],
    outputs: [reactions],
});

fn main() {}
