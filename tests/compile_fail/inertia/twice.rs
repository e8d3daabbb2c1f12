use newton_euler::{rigid_body, rigid_system};

rigid_body!(Roller {
    motion: rotation,
    mass: 1[kg],
    inertia: cylinder(0.1[m], 1[m]).along(body(0, 1, 0)).along(body(1, 0, 0)),
});

rigid_system!(Wheels {
    bodies: [wheel {
        copies: [x = body(1, 0, 0)],
        mass: 1[kg],
        inertia: cylinder(0.1[m], 1[m]).along(body(0, 1, 0)),
    }],
    joints: [spin = revolute(world(0, 0, 0), wheel_x.G, body(1, 0, 0))],
});

rigid_body!(Plate {
    motion: planar,
    mass: 1[kg],
    points: [p = (0.5, 0)[m], q = (0.3, 0)[m]],
    inertia: 3[kg * m ^ 2].about(p).about(q),
});

fn main() {}
