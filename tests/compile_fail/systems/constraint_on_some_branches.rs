use newton_euler::rigid_system;

rigid_system!(Mixed {
    motion: planar,
    bodies: [a { mass: 1[kg], inertia: 1[kg * m ^ 2] }],
    joints: [base = translation(a)],
    constraints: [
        slow = if a.velocity.in_world().x > 1[m / s] { a.position.in_world().y } else { a.velocity.in_world().y * 1[s] },
    ],
});

fn main() {}
