use newton_euler::rigid_body;

rigid_body!(Lever {
    motion: pivot(pin),
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    points: [pin = (1[m], 0)],
    constraints: [pace = angular_velocity - 2],
    reactions: [brake = moment(_)],
    forces: [push = body(0, _)],
    outputs: [inverse],
});

fn main() {}
