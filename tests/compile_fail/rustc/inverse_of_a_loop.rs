use newton_euler::rigid_system;

// a four-bar moves in one way
macro_rules! four_bar {
    ($name:ident, [$($drives:tt)*]) => {
        rigid_system!($name {
            motion: planar,
            bodies: [
                crank { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [o = (-0.05, 0), a = (0.05, 0)] },
                coupler { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [a = (-0.175, 0), b = (0.175, 0)] },
                rocker { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [b = (0.125, 0), c = (-0.125, 0)] },
            ],
            joints: [
                o = revolute(world(0, 0), crank.o),
                a = revolute(crank.a, coupler.a),
                b = revolute(coupler.b, rocker.b),
                c = revolute(world(0.3, 0), rocker.c),
            ],
            drives: [$($drives)*],
            outputs: [inverse],
        });
    };
}

four_bar!(Two, [first = _.on(o), second = _.on(a)]);
four_bar!(Three, [first = _.on(o), second = _.on(a), third = _.on(b)]);
four_bar!(Rubbed, [rub = (-0.01[m] * b.force).on(o), spring = (-2[N * m] * c.angle).on(a), first = _.on(a)]);

// a five-bar moves in two ways
rigid_system!(FiveBar {
    motion: planar,
    bodies: [
        left { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [o = (-0.05, 0), a = (0.05, 0)] },
        first { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [a = (-0.1, 0), b = (0.1, 0)] },
        second { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [b = (-0.1, 0), c = (0.1, 0)] },
        right { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [c = (-0.05, 0), o = (0.05, 0)] },
    ],
    joints: [
        o = revolute(world(0, 0), left.o),
        a = revolute(left.a, first.a),
        b = revolute(first.b, second.b),
        c = revolute(second.c, right.c),
        e = revolute(world(0.3, 0), right.o),
    ],
    drives: [motor = _.on(o)],
    outputs: [inverse],
});

fn main() {}
