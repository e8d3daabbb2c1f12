use newton_euler::rigid_system;

rigid_system!(Pendulum {
    motion: planar,
    bodies: [
        bob {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m]],
            pole: hinge,
            independent: [axle],
            reactions: [r = world(_, _).at(hinge)],
        },
    ],
    joints: [axle = revolute(world(0, 0), bob.hinge)],
});

fn main() {}
