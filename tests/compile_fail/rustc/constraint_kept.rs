//! A constraint that a joint keeps already, two that say the same, one that nothing can keep.

use newton_euler::prelude::*;

rigid_system!(Arms {
    motion: planar,
    inputs: [pivot[m]],
    bodies: [
        upper { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [hinge = (-0.3, 0)[m], tip = (0.3, 0)[m]] },
        lower { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [hinge = (-0.3, 0)[m]] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        away = free(lower),
    ],
    constraints: [
        held = upper.hinge.position(),
        together = upper.tip.position() - lower.hinge.position(),
        again = lower.hinge.velocity() - upper.tip.velocity(),
        late = 2 * t,
        moved = upper.tip.position().in_world().y - pivot,
        shoulder = upper.angular_velocity,
    ],
});

rigid_system!(Twice {
    motion: planar,
    bodies: [
        upper { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [hinge = (-0.3, 0)[m], tip = (0.3, 0)[m]] },
        lower { mass: 1[kg], inertia: 0.1[kg * m ^ 2], points: [hinge = (-0.3, 0)[m]] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        away = free(lower),
    ],
    constraints: [
        turn = upper.attitude + 2 * lower.attitude,
        together = upper.tip.position() - lower.hinge.position(),
        again = upper.angular_velocity + 2 * lower.angular_velocity,
    ],
});

fn main() {
    let _ = (Arms::default(), Twice::default());
}
