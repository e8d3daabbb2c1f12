use newton_euler::rigid_body;

rigid_body!(Stone::<type> {
    motion: translation,
    mass: 1[kg],
});

fn main() {}
