use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    /// Weighed twice.
    mass: 1[kg],
});

fn main() {}
