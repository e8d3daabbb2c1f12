use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    params: [m = 2[kg]],
    mass: m[kg],
});

fn main() {}
