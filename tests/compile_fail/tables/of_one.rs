use newton_euler::rigid_body;

rigid_body!(Wing {
    motion: translation,
    mass: 12[kg],
    params: [k = 2],
    inputs: [a[rad], s[m]],
    forces: [
        none = world(table(), 0, 0),
        few = world(table(a, [0], [1]), 0, 0),
        back = world(table(a, [0, 0.2, 0.1], [1, 2, 3]), 0, 0),
        same = world(table(a, [0, 0.1, 0.1], [1, 2, 3]), 0, 0),
        more = world(table(a, [0, 0.1, 0.2], [1, 2]), 0, 0),
        open = world(table(a, [0, 0.1, k], [1, 2, 3]), 0, 0),
        late = world(table(a, [0, 0.1, 0.2], [1, a, 3]), 0, 0),
        place = world(table(a, [0, 0.1, 0.2][m], [1, 2, 3]), 0, 0),
        mixed = world(table(s, [0, 0.1[m], 0.2[s]], [1, 2, 3]), 0, 0),
        twice = world(table(s, [0, 0.1[m], 0.2][m], [1, 2, 3]), 0, 0),
        value = world(table(s, [0, 0.1, 0.2][m], [1, 2, 3][m]), 0, 0),
        alone = world(table(s, 0.1, [1, 2, 3][N]), 0, 0),
        at = world(table(position, [0, 1], [1, 2]), 0, 0),
        word = world(table(a, [0, 1], [1, 2], cubik), 0, 0),
        list = world([0, 1], 0, 0),
        again = world(table(a, [0, 1], [1, 2], cubic, extrapolated, cubic), 0, 0),
        both = world(table(a, [0, 1], [1, 2], held, extrapolated), 0, 0),
    ],
});

fn main() {}
