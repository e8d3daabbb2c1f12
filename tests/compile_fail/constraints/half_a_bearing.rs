use newton_euler::rigid_body;

rigid_body!(Crank {
    motion: pivot(shaft),
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    points: [shaft = (1[m], 0)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [pace = angular_velocity - 2],
    reactions: [motor = moment(_), bearing = world(_, 0).at(shaft)],
});

fn main() {}
