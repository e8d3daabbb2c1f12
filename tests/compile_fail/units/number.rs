use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 2[10 * kg],
});

fn main() {}
