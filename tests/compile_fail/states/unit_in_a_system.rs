use newton_euler::rigid_system;

rigid_system!(Arm {
    motion: planar,
    inputs: [command[N * m]],
    states: [torque[N * m]],
    rates: [torque = shoulder.angle],
    bodies: [arm { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [hinge = (-0.3, 0)[m]] }],
    joints: [shoulder = revolute(world(0, 0), arm.hinge)],
    drives: [motor = torque.on(shoulder)],
});

fn main() {}
