use newton_euler::rigid_system;

rigid_system!(Swing {
    bodies: [
        wheel { mass: 1[kg], inertia: principal(1, 2, 2.5)[kg * m ^ 2], points: [rim = (0, 0, 1)[m]] },
    ],
    joints: [axle = revolute(world(0, 0, 0), wheel.hub(), world(1, 0, 0))],
});

fn main() {}
