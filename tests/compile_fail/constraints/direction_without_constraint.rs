use newton_euler::rigid_body;

rigid_body!(Body {
    motion: translation,
    mass: 1[kg],
    reactions: [guide = moment(_ * world(0, 0, 1))],
});

fn main() {}
