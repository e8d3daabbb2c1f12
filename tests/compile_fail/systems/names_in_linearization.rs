use newton_euler::rigid_system;

rigid_system!(Gantry {
    motion: planar,
    bodies: [
        beam { mass: 4[kg], inertia: 1[kg * m ^ 2], points: [tip = (1, 0)[m]] },
        trolley { mass: 1[kg], inertia: 0.1[kg * m ^ 2] },
    ],
    joints: [
        arm = revolute(world(0, 0), beam.G),
        arm_angular = prismatic(beam.tip, trolley.G, body(1, 0)),
    ],
    outputs: [linearization],
});

fn main() {}
