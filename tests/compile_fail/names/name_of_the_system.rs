use newton_euler::rigid_system;

rigid_system!(Pendulum {
    motion: planar,
    bodies: [bob { mass: 1[kg], inertia: disc(0.1[m]), points: [hook = (0, 1[m])] }],
    joints: [pin = revolute(world(0, 0), bob.hook)],
    drives: [spring = (-1[N * m] * Pendulum.angle).on(pin)],
});

fn main() {}
