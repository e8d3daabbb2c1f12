use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    inputs: [moving push[N]],
    forces: [wind = world(push, push_rate * 1[s], 0)],
});

fn main() {}
