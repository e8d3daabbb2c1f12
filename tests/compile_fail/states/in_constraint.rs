use newton_euler::rigid_body;

rigid_body!(Wheel {
    motion: planar,
    inputs: [command[rad / s]],
    states: [speed[rad / s], height[m]],
    rates: [
        speed = (command - speed) / 0.1[s],
        height = (velocity.in_world().y - height / 1[s]) / 2,
    ],
    mass: 2[kg],
    inertia: 1[kg * m ^ 2],
    locals: [far = 0.1[m * s] * speed],
    constraints: [
        rail = position.in_world().x - far,
        lift = position.in_world().y - height,
        spin = angular_velocity - speed,
    ],
    reactions: [guide = world(_, _), motor = moment(_)],
});

fn main() {}
