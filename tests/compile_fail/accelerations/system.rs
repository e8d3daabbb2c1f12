use newton_euler::rigid_system;

rigid_system!(Pendulums {
    motion: planar,
    bodies: [
        upper {
            mass: 2[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [top = (0, 0.5), low = (0, -0.5)],
            forces: [water = -0.7[kg * s ^ 2 / m] * acceleration.norm() * acceleration],
            potentials: [lifted = mass * acceleration.dot(position)],
        },
        lower {
            mass: 1[kg],
            inertia: 0.05[kg * m ^ 2],
            points: [top = (0, 0.4)],
            moments: [turned = -0.02[kg * m ^ 2 * s ^ 2] * upper.angular_acceleration.powi(2)],
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.top),
        elbow = revolute(upper.low, lower.top),
    ],
    drives: [rotor = (-0.04[kg * m ^ 2] * elbow.angular_acceleration.abs()).on(elbow)],
});

fn main() {}
