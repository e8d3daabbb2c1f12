use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    params: [g = 9.81[m / s ^ 2]],
    fields: [weight = mass g * world(0, 0, -1)],
});

fn main() {}
