use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: Motion::PlanarTranslation,
    mass: 1[kg],
});

fn main() {}
