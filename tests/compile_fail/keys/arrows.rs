use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass -> 1[kg],
    doc => "A stone.",
});

fn main() {}
