use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    forces: [
        first = if not t > 1[s] { world(1, 0, 0) } else { world(0, 0, 0) },
        second = if not(t > 1[s]) { world(1, 0, 0) } else { world(0, 0, 0) },
    ],
});

fn main() {}
