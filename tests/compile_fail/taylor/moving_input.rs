use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar_translation,
    mass: 1[kg],
    inputs: [hook = world(_, _)[m].moving],
    forces: [spring = -3[N / m] * (position - hook)],
    outputs: [taylor],
});

fn main() {}
