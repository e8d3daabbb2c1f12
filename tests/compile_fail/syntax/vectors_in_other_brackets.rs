use newton_euler::rigid_body;

rigid_body!(Brick {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 2, 2.5)[kg * m ^ 2],
    inputs: [wind = world[_, _, _][N]],
    points: [p = body { x: 0.1, y: 0, z: 0 }],
    forces: [push = world[0, 0, 1][N].at[p], gust = wind],
});

fn main() {}
