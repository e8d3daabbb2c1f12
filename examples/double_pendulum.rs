//! A double pendulum: chaos, and an energy that stays.
fn main() {
    println!("{}", DoublePendulum::EQUATIONS);
    for o in DoublePendulum::OPERATIONS {
        println!("{o:?}");
    }
}
use newton_euler::prelude::*;
rigid_system!(DoublePendulum {
    motion: planar,
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower {
            mass: 0.8[kg],
            inertia: 0.015[kg * m ^ 2],
            points: [hinge = (-0.22, 0)[m]]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [energy, reactions],
});
