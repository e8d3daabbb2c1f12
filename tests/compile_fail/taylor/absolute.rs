use newton_euler::rigid_body;

rigid_body!(Wheel {
    motion: fixed_axis(G, world(0, 0, 1)),
    mass: 2[kg],
    inertia: principal(1, 1, 2)[kg * m ^ 2],
    locals: [rate = angular_velocity.in_body().z],
    moments: [
        drag = body(0, 0, -0.1[N * m * s ^ 2] * rate.abs() * rate),
        push = body(0, 0, (0.2[N * m]).min(0.1[N * m * s] * rate)),
        smooth = body(0, 0, -0.1[N * m * s] * rate),
    ],
    outputs: [taylor],
});

fn main() {}
