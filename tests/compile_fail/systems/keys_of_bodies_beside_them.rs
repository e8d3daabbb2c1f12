use newton_euler::rigid_system;

rigid_system!(Bob {
    mass: 1[kg],
    inertia: sphere(0.1[m]),
    points: [hook = (0, 0, 1[m])],
    pole: G,
    bodies: [bob {}],
    joints: [cord = spherical(world(0, 0, 0), bob.hook)],
});

fn main() {}
