use newton_euler::rigid_body;

rigid_body!(Wing {
    motion: translation,
    mass: 12[kg],
    inputs: [a[rad], v[m / s]],
    forces: [
        rows = world(table(a, v, [0, 1], [0, 1, 2][m / s], [[0, 1, 2]]), 0, 0),
        columns = world(table(a, v, [0, 1], [0, 1, 2][m / s], [[0, 1, 2], [0, 1]]), 0, 0),
        flat = world(table(a, v, [0, 1], [0, 1], [0, 1]), 0, 0),
        smooth = world(table(a, v, [0, 1], [0, 1], [[0, 1], [1, 2]], cubick), 0, 0),
        units = world(table(a, v, [0, 1], [0, 1], [[0, 1][N], [1, 2][m]]), 0, 0),
    ],
});

fn main() {}
