use newton_euler::rigid_system;

rigid_system!(Pendulum {
    motion: planar,
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower,
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
});

fn main() {}
