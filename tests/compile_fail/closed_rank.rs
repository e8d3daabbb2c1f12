use newton_euler::prelude::*;

// three parallel cranks: what each carries is not determined, where the coupler is
rigid_system!(Cranks {
    motion: planar,
    bodies: [
        first {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [o = (0, -0.5), a = (0, 0.5)]
        },
        coupler {
            mass: 2[kg],
            inertia: 0.8[kg * m ^ 2],
            points: [a = (-1, 0), b = (0, 0), c = (1, 0)]
        },
        second {
            mass: 1.5[kg],
            inertia: 0.2[kg * m ^ 2],
            points: [p = (0, -0.5), b = (0, 0.5)]
        },
        third {
            mass: 0.7[kg],
            inertia: 0.15[kg * m ^ 2],
            points: [q = (0, -0.5), c = (0, 0.5)]
        },
    ],
    joints: [
        o = revolute(world(0, 0), first.o),
        a = revolute(first.a, coupler.a),
        b = revolute(coupler.b, second.b),
        c = revolute(coupler.c, third.c),
        p = revolute(world(1, 0), second.p),
        q = revolute(world(2, 0), third.q),
    ],
    outputs: [reactions(o)],
});

fn main() {}
