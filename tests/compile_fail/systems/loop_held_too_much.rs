use newton_euler::rigid_system;

rigid_system!(Hyperstatic {
    bodies: [
        crank { mass: 1[kg], inertia: principal(1, 1, 1), points: [o = (0, 0, 0), a = (0.3, 0.4, 0)] },
        coupler { mass: 1[kg], inertia: principal(1, 1, 1), points: [a = (0, 0, 0), b = (0.6, 0.8, 0)] },
        rocker { mass: 1[kg], inertia: principal(1, 1, 1), points: [b = (0, 0, 0), c = (0.1, -1.2, 0)] },
    ],
    joints: [
        o = revolute(world(0, 0, 0), crank.o, body(0, 0, 1)),
        a = revolute(crank.a, coupler.a, body(0, 0, 1)),
        b = revolute(coupler.b, rocker.b, body(0, 0, 1)),
        c = revolute(world(1, 0, 0), rocker.c, body(0, 0, 1)),
    ],
    outputs: [reactions],
});

// what stands beside the loop is determined, and what is in it is not
rigid_system!(Some {
    bodies: [
        base { mass: 1[kg], inertia: principal(1, 1, 1), points: [side = (1, 0, 0)] },
        crank { mass: 1[kg], inertia: principal(1, 1, 1), points: [o = (0, 0, 0), a = (0.3, 0.4, 0)] },
        coupler { mass: 1[kg], inertia: principal(1, 1, 1), points: [a = (0, 0, 0), b = (0.6, 0.8, 0)] },
        rocker { mass: 1[kg], inertia: principal(1, 1, 1), points: [b = (0, 0, 0), c = (0.1, -1.2, 0)] },
    ],
    joints: [
        foot = weld(world(0, 0, 0), base.G),
        o = revolute(base.G, crank.o, body(0, 0, 1)),
        a = revolute(crank.a, coupler.a, body(0, 0, 1)),
        b = revolute(coupler.b, rocker.b, body(0, 0, 1)),
        c = revolute(base.side, rocker.c, body(0, 0, 1)),
    ],
    outputs: [reactions(foot, a)],
});

rigid_system!(Inverse {
    motion: planar,
    inputs: [torque[N * m]],
    bodies: [
        crank { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [o = (0, 0), a = (0.3, 0.4)] },
        coupler { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [a = (0, 0), b = (0.6, 0.8)] },
    ],
    joints: [
        o = revolute(world(0, 0), crank.o),
        a = revolute(crank.a, coupler.a),
        guide = prismatic(world(1, 0), coupler.b, body(1, 0)).driven(0.2[m]),
    ],
    drives: [pull = torque.on(guide), other = (torque * guide.position).on(a)],
});

rigid_system!(Free {
    motion: planar,
    bodies: [
        crank { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [o = (0, 0), a = (0.3, 0.4)] },
        coupler { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [a = (0, 0), b = (0.6, 0.8)] },
    ],
    joints: [
        o = revolute(world(0, 0), crank.o),
        a = revolute(crank.a, coupler.a),
        guide = prismatic(world(1, 0), coupler.b, body(1, 0)),
        b = free(coupler),
    ],
    drives: [pull = (2[N]).on(guide), other = (2[N * m / m] * guide.position).on(a)],
    outputs: [inverse],
});

fn main() {}
