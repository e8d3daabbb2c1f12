use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    fields: [weight = m * world(0, 0, -9.80665[m / s ^ 2])],
});

fn main() {}
