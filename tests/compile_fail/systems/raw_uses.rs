use newton_euler::rigid_system;

rigid_system!(Hung {
    params: [weight = 1[kg]],
    bodies: [b { mass: r#weight, inertia: sphere(0.1), points: [top = (0, 0, 1)] }],
    joints: [hinge = revolute(world(0, 0, 0), b.r#top, world(0, 1, 0))],
    potentials: [spring = 5[N / m] * b.r#top.position().norm_squared()],
});

fn main() {}
