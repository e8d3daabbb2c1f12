use newton_euler::{rigid_body, rigid_system};

// the pin is unknown: nothing follows from it for the inertia
rigid_body!(Misspelt {
    motion: pivot(pn),
    mass: 1[kg],
    inertia: 0[kg * m ^ 2],
    points: [pin = (1, 0)[m]],
});

rigid_body!(WithoutAxes {
    motion: fixed_axis(pin, (0, 1, 0)),
    mass: 1[kg],
    inertia: principal(0, 0, 0)[kg * m ^ 2],
    points: [pin = (1, 0, 0)[m]],
});

rigid_system!(Joints {
    bodies: [
        a { mass: 1[kg], inertia: principal(0, 0, 0)[kg * m ^ 2], points: [p = (1, 0, 0)[m]] },
        b { mass: 1[kg], inertia: rod(1[m]).along(body(1, 0, 0)), points: [p = (0.5, 0, 0)[m]] },
    ],
    joints: [
        first = revolute(world(0, 0, 0), a.pp, body(0, 1, 0)),
        second = revlute(a.G, b.p, body(0, 1, 0)),
    ],
});

// on a frame that moves, the inertia of a rod vanishes where the axes agree
rigid_system!(OnAFrame {
    bodies: [
        yoke { mass: 0[kg] },
        arm { mass: 1[kg], inertia: rod(1[m]).along(body(1, 0, 0)), points: [p = (0.5, 0, 0)[m]] },
    ],
    joints: [
        turn = revolute(world(0, 0, 0), yoke.G, body(1, 0, 0)),
        swing = revolute(yoke.G, arm.p, body(0, 1, 0)),
    ],
});

fn main() {}
