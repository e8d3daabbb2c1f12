use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    forces: [weight = mass * g * world(0, 0, -1)],
});

fn main() {}
