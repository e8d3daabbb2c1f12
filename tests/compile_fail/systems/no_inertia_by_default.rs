use newton_euler::{rigid_body, rigid_system};

rigid_system!(Bob {
    motion: planar,
    params: [length = 0[m]],
    bodies: [bob { mass: 1[kg], inertia: 0[kg * m ^ 2], points: [eye = (0, length)] }],
    joints: [string = revolute(world(0, 0), bob.eye)],
});

rigid_body!(Bead {
    motion: pivot(eye),
    params: [length = 0[m]],
    mass: 1[kg],
    inertia: 0[kg * m ^ 2],
    points: [eye = (0, length)],
});

fn main() {}
