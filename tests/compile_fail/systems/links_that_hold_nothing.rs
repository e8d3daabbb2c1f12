use newton_euler::rigid_system;

rigid_system!(Table {
    params: [reach = 2[m]],
    inputs: [stretch[m]],
    bodies: [
        plate { mass: 1[kg], inertia: principal(2, 3, 4)[kg * m ^ 2], points: [p = (0.1, 0, 0)] },
        foot { mass: 1[kg], inertia: principal(2, 3, 4)[kg * m ^ 2], points: [p = (0.1, 0, 0)] },
    ],
    joints: [
        orbit = free(plate),
        other = free(foot),
        a = link(world(0, 0, 0), plate.p),
        b = link(world(0, 0, 0), plate.p, 2[m], 3[m]),
        c = link(world(0, 0, 0), plate, 2[m]),
        d = link(plate.G, plate.p, 2[m]),
        e = link(plate.q, foot.p, 2[m]),
        f = link(plate.p, foot.p, 2[N]),
        g = link(plate.p, foot.p, 0[m]),
        i = link(plate.p, foot.p, -1[m]),
        j = link(plate.p, foot.p, foot.G.velocity().norm() * 1[s]),
        k = link(plate.p, foot.p, reach + stretch),
        l = link(plate.p, foot.p, reach).turned(body(0, 0, 1), 1),
        m = link(plate.p, orbit, reach),
        n = link(plate.position, foot.p, reach),
        plate = link(plate.p, foot.p, reach),
        o = link(world(0, 0, 0), world(1, 0, 0), reach),
        p = link(world(0, 0, 0)[N], foot.p, reach),
        q = link(world(t, 0, 0)[m], foot.p, reach),
    ],
});

fn main() {}
