use newton_euler::rigid_system;

rigid_system!(Raw {
    bodies: [
        r#type { mass: 1[kg], inertia: principal(1, 1, 1)[kg * m ^ 2], points: [r#fn = (0.1, 0, 0)[m]] },
        part {
            copies: [r#do, last],
            mass: 1[kg],
            inertia: principal(1, 1, 1)[kg * m ^ 2],
            constraints: [r#while = velocity.norm() - 1[m / s]],
        },
    ],
    joints: [orbit = free(r#type), first = free(part_do), second = free(part_last)],
    outputs: [jacobian(r#type.r#fn)],
});

fn main() {}
