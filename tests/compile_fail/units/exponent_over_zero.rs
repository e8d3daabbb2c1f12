use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    params: [stiffness = 2[N / m ^ (3/0)]],
    mass: 2[kg],
});

fn main() {}
