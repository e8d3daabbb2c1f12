newton_euler::rigid_body!(Peg {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1),
    params: [angle[rad]],
    points: [end = (2, angle, 3)],
    forces: [push = world(1, 0, 0).at(end)],
});

fn main() {}
