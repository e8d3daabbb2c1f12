use newton_euler::rigid_system;

rigid_system!(Pendulum {
    motion: planar,
    bodies: [bob { mass: 1[kg], inertia: disc(0.1[m]), points: [hook = (0, 1[m])] }],
    joints: [revolute pin(world(0, 0), bob.hook)],
});

fn main() {}
