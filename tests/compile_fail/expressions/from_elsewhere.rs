use newton_euler::{rigid_body, rigid_system};

rigid_body!(Drone {
    motion: free,
    mass: 1.2[Kg],
    inertia: principal(0.01, 0.01, 0.02)[kg * m ^ 2],
});

rigid_body!(Keys {
    motion: rotation,
    center_of_mass: (0, 0, 0),
    initial: 3,
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    moments: [turn = body(attitude[0] * 1[N * m], 0, 0)],
});

rigid_body!(Signs {
    motion: translation,
    inputs: [thrust[N]],
    mass: 1[kg],
    locals: [slow = velocity.norm()["m / s"], fast = velocity.norm()[m * s ** 2], area = 1[N.m]],
    forces: [
        up = world(0, 0, thrust > 0 ? thrust : 0),
        side = world(0, crate::FORCE, 0),
        top = world(f64::MAX, 0, 0),
        part = up::z * world(0, 0, 1),
    ],
    outputs: ["energy"],
});

rigid_body!(Plank {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    moments: [damping = -1[N * m * s] * angular_velocity.z],
});

rigid_system!(Arms {
    motion: planar,
    inputs: [torque[N * m]],
    bodies: [
        upper { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [hinge = (0, 0.2)[m], tip = (0, -0.2)[m]] },
        lower { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [hinge = (0, 0.2)[m]] },
    ],
    joints: [
        shoulder = revolute(world(0, 0) -> upper.hinge),
        elbow = revolute(upper.tip lower.hinge),
        wrist = revolute(upper.tip, lower.hinge, damping = 0.1),
        loose = free(upper, lower),
    ],
    drives: [motor = torque.on(elbow) - 0.1[N * m * s] * elbow.angular_velocity],
});

fn main() {}
