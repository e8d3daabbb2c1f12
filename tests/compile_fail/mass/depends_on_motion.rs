use newton_euler::{rigid_body, rigid_system};

rigid_body!(Drone {
    motion: spatial,
    states: [fuel[kg]],
    rates: [fuel = -0.1[kg / s]],
    mass: 1.2[kg] + fuel - 0.1[kg * s / m] * velocity.norm(),
    inertia: principal(0.02, 0.03, 0.04 * attitude.w)[kg * m ^ 2],
});

// and in systems
rigid_system!(Arm {
    motion: planar,
    states: [fuel[kg]],
    rates: [fuel = -0.1[kg / s]],
    inputs: [supply[kg]],
    bodies: [rod { mass: 2[kg] + fuel + supply, inertia: 0.3[kg * m ^ 2] }],
    joints: [hinge = revolute(world(0, 0), rod.G)],
});

fn main() {}
