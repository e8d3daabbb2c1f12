use newton_euler::rigid_body;

rigid_body!(Wheel {
    motion: pivot(pin),
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    points: [pin = (0.4, 0.1)],
    reactions: [bearing = world(_, _).at(pin)],
    joint_moments: [rub = -0.1[m] * bearing.in_world().x],
    outputs: [reactions],
});

fn main() {}
