use newton_euler::rigid_body;

rigid_body!(Stone::<T, U> {
    motion: translation,
    mass: 1[kg],
});

fn main() {}
