use newton_euler::rigid_body;

rigid_body!(
    /// A thrown stone.
    Stone {
        motion: translation,
        mass: 1[kg],
    }
);

fn main() {}
