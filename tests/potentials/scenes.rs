//! Bodies with potentials of every kind.

newton_euler::rigid_body!(Craft {
    doc: "Springs, a central field of a quadrupole, a torsion spring of the attitude, an uneven magnetic field.",
    motion: spatial,
    params: [k = 20[N / m], rest = 0.7[m], far = world(1, 2, 13)[m]],
    inputs: [pull[N]],
    mass: 2,
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    },
    points: [
        hook = (0.3, 0.1, -0.2),
        tail = (-0.5, 0, 0),
        post = world(-9, 1, 0)
    ],
    locals: [
        rope = far - hook.position(),
        taut = (tail.position() - post.position()).norm() - 8[m],
        from_sun = (position - world(0, 30, 0)).in_body(),
        distance = (position - world(0, 30, 0)).norm(),
        uphill = position.in_world(),
    ],
    potentials: [
        spring = k / 2 * (rope.norm() - rest).powi(2),
        soft = k / 2 * (tail.position() - post.position()).norm_squared(),
        slack = if taut > 0 { k * taut.powi(2) } else { 0 },
        quadrupole = (40 * from_sun.x * from_sun.y - 70 * from_sun.z.powi(2)) / distance.powi(5),
        torsion = 3 * (attitude.i.powi(2) + attitude.j * attitude.w),
        magnet = -body(0.3, -0.2, 0.5).dot(world(
            0.1 * uphill.y,
            0.1 * uphill.x,
            2 + 0.3 * (2 * t).sin()
        )),
        towed = -pull * (world(0, 1, 0).dot(hook.position())),
        capped = 1[N / m ^ 2] * hook.position().in_world().z.min(0.4).max(-3).powi(3),
    ],
    outputs: [energy, balance],
});

newton_euler::rigid_body!(Needle {
    motion: rotation,
    params: [moment = body(0.3, -0.2, 0.5)],
    inertia: principal(1.3, 1.7, 2.1),
    locals: [along = moment.in_world()],
    potentials: [
        magnet = -moment.dot(world(1, 2, 3)),
        easy = along.x * along.y + 0.5 * along.z.powi(3),
    ],
    outputs: [energy, balance],
});

newton_euler::rigid_body!(Raft {
    motion: planar,
    params: [rest = 0.7[m]],
    mass: 2,
    inertia: 0.6,
    points: [bow = (0.5, 0.1), post = world(8, 9)],
    locals: [taut = (bow.position() - post.position()).norm() - rest],
    potentials: [
        rope = 10 * taut.powi(2),
        coil = 0.7 * attitude.powi(2),
        slope = 3 * (0.5 * bow.position().in_world().y).sin(),
        seen = 0.2 * (position - world(1, 1)).in_body().x.powi(2),
    ],
    outputs: [energy, balance],
});

newton_euler::rigid_body!(Top {
    motion: fixed_point(tip).at(world(0.5, 0, 1)),
    mass: 2,
    inertia: principal(1.3, 1.3, 0.9),
    points: [
        tip = (0, 0.1, -0.6),
        rim = (0.3, 0, 0.2),
        post = world(1, 2, 3)
    ],
    potentials: [
        weight = mass * 9.8 * position.in_world().z,
        spring = 6 * ((rim.position() - post.position()).norm() - 1).powi(2),
    ],
    reactions: [ground = world(_, _, _).at(tip)],
    outputs: [energy, balance, reactions],
});

newton_euler::rigid_body!(Door {
    motion: fixed_axis(lower, body(0, 0.6, 0.8)),
    mass: 20,
    inertia: tensor {
        xx: 3,
        yy: 4,
        zz: 5,
        xy: 0.1
    },
    points: [
        lower = (-0.4, 0, -0.9),
        handle = (0.4, 0.05, 0.1),
        post = world(1, 2, 0.5)
    ],
    locals: [stretch = (handle.position() - post.position()).norm() - 0.3],
    potentials: [
        closer = 4 * stretch.powi(2),
        coil = 2 * (attitude - 0.3).powi(2),
        weight = mass * 9.8 * position.in_world().z,
    ],
    outputs: [energy, balance],
});

newton_euler::rigid_body!(Gate {
    motion: fixed_axis(lower, body(0, 0, 1)),
    mass: 20,
    inertia: tensor {
        xx: 3,
        yy: 4,
        zz: 5,
        xy: 0.1
    },
    points: [
        lower = (-0.4, 0, -0.9),
        handle = (0.4, 0.05, 0.1),
        post = world(1, 2, 0.5)
    ],
    locals: [stretch = (handle.position() - post.position()).norm() - 0.3],
    potentials: [
        closer = 4 * stretch.powi(2),
        coil = 2 * (attitude - 0.3).powi(2),
        weight = mass * 9.8 * position.in_world().z,
    ],
    reactions: [
        hinge = body(_, _, _).at(lower),
        frame = moment(body(_, _, 0))
    ],
    outputs: [balance, reactions],
});

newton_euler::rigid_body!(Bead {
    motion: translation,
    mass: 2,
    locals: [r = position.norm_squared()],
    potentials: [trap = 3 * r + (r - 4).powi(2) / 100 - 5 / (r + 1).sqrt()],
    outputs: [energy, balance],
});

newton_euler::rigid_body!(Puck {
    motion: planar_translation,
    mass: 2,
    potentials: [bowl = 3 * position.norm_squared() + 0.1 * position.in_world().x.powi(3)],
    outputs: [energy, balance],
});

newton_euler::rigid_body!(Moored {
    doc: "A spring to somewhere far.",
    motion: planar,
    inputs: [k[N / m]],
    mass: 2,
    inertia: 3,
    points: [cleat = (0.25, -0.5), quay = world(1e9, 2e9)],
    potentials: [rope = k / 2 * (quay.position() - cleat.position()).norm_squared()],
    outputs: [balance],
});

newton_euler::rigid_body!(Towed {
    doc: "Springs of one potential to somewhere far, some with a rest length; those without one cancel.",
    motion: spatial,
    params: [k = 4[N / m]],
    inputs: [h[N / m]],
    mass: 2,
    inertia: principal(1, 2, 2.5),
    points: [
        bow = (0.25, 0, 1),
        stern = (-0.5, 0.75, 0),
        quay = world(1e9, 2e9, -3e9)
    ],
    locals: [
        to_bow = quay.position() - bow.position(),
        to_stern = quay.position() - stern.position()
    ],
    potentials: [ropes = k / 2 * (to_bow.norm() - 3[m]).powi(2)
        + h / 2 * (to_stern.norm() - 5[m]).powi(2)
        + 2 * k * to_bow.norm_squared()
        - 2 * k * to_stern.norm_squared(),],
    outputs: [balance],
});

newton_euler::rigid_body!(Guided {
    doc: "The same with a rest length, on guides.",
    motion: translation,
    inputs: [k[N / m]],
    mass: 2,
    points: [cleat = (0.25, -0.5, 1), quay = world(1e9, 2e9, 0)],
    potentials: [rope = k / 2 * ((quay.position() - cleat.position()).norm() - 3[m]).powi(2),],
    reactions: [guide = moment(world(_, _, _))],
    outputs: [balance, reactions],
});

newton_euler::rigid_body!(Braced {
    doc: "Two springs to one place, of stiffnesses that may vanish or cancel.",
    motion: spatial,
    params: [k = 1[N / m], h = 1[N / m]],
    mass: 2,
    inertia: principal(1, 2, 2.5),
    points: [
        tip = (0.5, 0, 0.25),
        foot = (0, -0.5, 0),
        wall = world(3, 2, -1)
    ],
    potentials: [
        springs = k / 2 * (tip.position() - wall.position()).norm_squared()
            + h / 2 * (foot.position() - wall.position()).norm_squared(),
    ],
    outputs: [balance],
});
