use newton_euler::rigid_body;

rigid_body!(Body {
    motion: pivot(P),
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    points: [P = (1, 0)],
    constraints: [turned = attitude - t],
    reactions: [drive = moment(_)],
});

fn main() {}
