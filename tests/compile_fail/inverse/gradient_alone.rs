use newton_euler::prelude::*;

rigid_body!(Wheel {
    motion: planar,
    params: [l = 0.3[m]],
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    constraints: [c = position.in_world().y - l * attitude],
    reactions: [n = _ * c.gradient()],
    outputs: [inverse],
});

fn main() {}
