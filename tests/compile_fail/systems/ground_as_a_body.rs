use newton_euler::rigid_system;

rigid_system!(Pendulum {
    motion: planar,
    bodies: [
        base { points: [pin = (0, 0)] },
        upper { mass: 1.2[kg], inertia: 0.04[kg * m ^ 2], points: [hinge = (-0.28, 0)[m]] },
    ],
    joints: [shoulder = revolute(base.pin, upper.hinge)],
});

fn main() {}
