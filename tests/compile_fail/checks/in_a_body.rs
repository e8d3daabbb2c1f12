use newton_euler::rigid_system;

rigid_system!(Arms {
    motion: planar,
    inputs: [torque[N * m]],
    bodies: [
        upper { mass: 1.2[kg], inertia: 0.04[kg * m ^ 2], points: [hinge = (-0.3, 0), tip = (0.3, 0)], checks: [light = mass < 2[kg]] },
        lower { mass: 0.8[kg], inertia: 0.015[kg * m ^ 2], points: [hinge = (-0.2, 0)] },
    ],
    joints: [shoulder = revolute(world(0, 0), upper.hinge), elbow = revolute(upper.tip, lower.hinge)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    drives: [motor = torque.on(shoulder)],
    checks: [
        light = upper.mass < 2[kg],
    ],
});

fn main() {}
