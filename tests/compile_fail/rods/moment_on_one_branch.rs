use newton_euler::rigid_body;

rigid_body!(Stick {
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: rod(0.5[m]),
    moments: [
        twist = if t > 3[s] {
            world(0, 0, 1)[N * m]
        } else {
            1[N * m] * axis.cross(world(0, 0, 1))
        },
    ],
});

fn main() {}
