use newton_euler::prelude::*;

rigid_body!(Pendulum {
    motion: pivot(e),
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [e = (0.1, 0.2)],
    reactions: [r = world(_, _).at(e)],
    outputs: [inverse],
});

fn main() {}
