use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    inputs: [height[m].moving, height_rate[m / s]],
    forces: [push = world(0, height * 1[N / m] + height_rate * 1[N * s / m])],
});

fn main() {}
