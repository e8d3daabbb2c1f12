use newton_euler::rigid_body;

rigid_body!(Wing {
    motion: translation,
    mass: 12[kg],
    functions: [
        none() = crate::lift,
        bare = crate::lift,
        lift[N](alpha) = crate::lift,
        many(a, b, c, d) = crate::lift,
        same(a, a) = crate::lift,
        odd(a + 1) = crate::lift,
        path(a) = crate::lift + 1,
        value(a),
        few(a, b) = crate::lift.derivatives(crate::slope),
        word(a) = crate::lift.slopes(crate::slope),
        sin(a) = crate::lift,
        unit(a[furlong]) = crate::lift,
        crate::lift(a) = crate::lift,
        slope(a) = crate::lift.derivatives(1),
    ],
    forces: [pull = (none(1) + bare(2) + lift(3) + many(4)) * world(1, 0, 0)],
});

fn main() {}
