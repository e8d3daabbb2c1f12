use newton_euler::prelude::*;

rigid_system!(Arm {
    drawng: zero_pose,
    bodies: [
        upper { mass: 1[kg], inertia: sphere(0.1[m]).at((0, 0, 1)) },
        lower { mass: 1[kg], inertia: sphere(0.1[m]).at((0, 0, 2)) },
    ],
    joints: [
        shoulder = revolute(world, upper, (0, 1, 0)).at((0, 0, 0)),
        elbow = revolute(upper, lower, (0, 1, 0)).at((0, 0, 1.5)),
    ],
});

fn main() {}
