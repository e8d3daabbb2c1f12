use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar_translation,
    mass: 1[kg],
    inputs: [hook[m].moving, wind[m / s]],
    forces: [
        spring = world(0, -3[N / m] * (hook.abs() - position.in_world().y)),
        winch = world(if hook_rate > 0.1[m / s] { 2[N] } else { 1[N] }, 0),
        drag = world(-0.1[N * s / m] * wind.abs(), 0),
    ],
    outputs: [taylor],
});

fn main() {}
