use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    params { drag: 0.1[N * s / m] },
    forces: [air = -drag * velocity],
});

fn main() {}
