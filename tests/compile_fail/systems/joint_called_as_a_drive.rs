use newton_euler::prelude::*;

rigid_system!(Crank {
    bodies: [
        arm { mass: 1[kg], inertia: principal(1, 2, 2.5)[kg * m ^ 2] },
        rod { mass: 1[kg], inertia: principal(1, 2, 2.5)[kg * m ^ 2] },
    ],
    joints: [
        crank = revolute(world(0, 0, 0), arm.G, body(0, 0, 1)).driven(2[rad / s] * t),
        crank_drive = revolute(arm.G, rod.G, body(1, 0, 0)),
    ],
    outputs: [reactions],
});

fn main() {}
