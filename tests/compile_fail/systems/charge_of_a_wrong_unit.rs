use newton_euler::rigid_system;

rigid_system!(Pendulum {
    motion: planar,
    bodies: [
        bob {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m]],
            fields: [e = world(1, 2)[V / m].on([1[kg].at(hinge), 2[C].at(tip)])],
        },
    ],
    joints: [axle = revolute(world(0, 0), bob.hinge)],
    fields: [all = world(1, 2)[V / m].on([1[C].at(hook)])],
});

fn main() {}
