use newton_euler::rigid_system;

rigid_system!(Arm {
    motion: planar,
    inputs: [command[N * m]],
    states: [shoulder[N * m]],
    rates: [shoulder = (command - shoulder) / 0.1[s]],
    bodies: [arm { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [hinge = (-0.3, 0)[m]] }],
    joints: [shoulder = revolute(world(0, 0), arm.hinge)],
});

fn main() {}
