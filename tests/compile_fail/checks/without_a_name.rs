use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    checks: [mass < 2[kg], mass == 1[kg]],
});

fn main() {}
