use newton_euler::rigid_body;

rigid_body!(Arm {
    motion: pivot(pin),
    mass: 2[kg],
    inertia: 0.2[kg * m ^ 2],
    points: [pin = (0, 0.35)],
    moments: [motor = _],
    joint_moments: [belt = _],
    outputs: [inverse],
});

fn main() {}
