use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    rates: [heat = 1[W]],
    forces: [push = world(heat * 1[N / J], 0, 0)],
});

fn main() {}
