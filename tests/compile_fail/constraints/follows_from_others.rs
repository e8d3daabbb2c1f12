use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    points: [left = (-1, 0), right = (1, 0)],
    constraints: [
        held = left.position(),
        level = position.in_world().y,
        upright = left.position().in_world().x - right.position().in_world().x,
    ],
    reactions: [
        a = world(_, _).at(left),
        b = world(0, _).at(right),
        c = world(_, 0)
    ],
});

fn main() {}
