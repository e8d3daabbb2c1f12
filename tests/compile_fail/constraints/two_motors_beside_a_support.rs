use newton_euler::rigid_body;

rigid_body!(Crank {
    motion: pivot(shaft),
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    points: [shaft = (1[m], 0)],
    constraints: [pace = angular_velocity - 2],
    reactions: [motor = moment(_), other = moment(_)],
});

fn main() {}
