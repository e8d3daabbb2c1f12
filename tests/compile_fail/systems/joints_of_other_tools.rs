use newton_euler::rigid_system;

rigid_system!(Arm {
    bodies: [
        a { mass: 1[kg], inertia: sphere(0.1[m]), points: [p = (-0.1, 0, 0), q = (0.1, 0, 0)] },
        b { mass: 1[kg], inertia: sphere(0.1[m]), points: [p = (-0.1, 0, 0), q = (0.1, 0, 0)] },
        c { mass: 1[kg], inertia: sphere(0.1[m]), points: [p = (-0.1, 0, 0), q = (0.1, 0, 0)] },
        d { mass: 1[kg], inertia: sphere(0.1[m]), points: [p = (-0.1, 0, 0)] },
        e { mass: 1[kg], inertia: sphere(0.1[m]), points: [] },
    ],
    joints: [
        first = hinge(world(0, 0, 0), a.p, body(0, 0, 1)),
        second = Slider(a.q, b.p, body(0, 0, 1)),
        third = ball(b.q, c.p),
        fourth = fixed(c.q, d.p),
        fifth = floating(e),
    ],
});

fn main() {}
