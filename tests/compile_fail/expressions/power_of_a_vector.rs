use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    forces: [drag = -0.1[N * s ^ 2 / m ^ 2] * velocity.powi(2)],
});

fn main() {}
