use newton_euler::rigid_body;

rigid_body!(Body {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    inputs: [pivot = world(_, _)[m]],
    points: [pin = (0, 0.5)[m]],
    constraints: [held = pin.position() - pivot],
    reactions: [hinge = world(_, _).at(pin)],
});

fn main() {}
