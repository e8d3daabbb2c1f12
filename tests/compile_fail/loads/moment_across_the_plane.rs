use newton_euler::rigid_body;

rigid_body!(Wheel {
    motion: planar,
    mass: 1[kg],
    inertia: disk(1[m]),
    moments: [
        motor = body(0, 0, 1[N * m]),
        brake = -0.1[N * m * s] * angular_velocity * world(0, 0, 1),
    ],
    forces: [turn = 1[N * m]],
});

fn main() {}
