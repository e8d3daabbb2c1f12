use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass,
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});

fn main() {}
