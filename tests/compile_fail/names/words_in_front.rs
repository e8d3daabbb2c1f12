use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    forces: [vector push = world(1[N], 0, 0)],
});

fn main() {}
