use newton_euler::rigid_system;

rigid_system!(Hung {
    bodies: [b { mass: 1[kg], inertia: sphere(0.1), points: [in = (0, 0, 1)] }],
    joints: [hinge = revolute(world(0, 0, 0), b.in, world(0, 1, 0))],
    potentials: [spring = 5[N / m] * b.in.position().norm_squared()],
});

fn main() {}
