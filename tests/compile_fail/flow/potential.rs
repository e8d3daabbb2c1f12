use newton_euler::rigid_body;

rigid_body!(Bead {
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [end = (1[m], 0, 0)],
    potentials: [spring = 4[N / m] * end.position().dot(end.position()) / 2],
    outputs: [flow],
});

fn main() {}
