use newton_euler::rigid_system;

rigid_system!(Swing {
    motion: planar,
    bodies: [
        seat { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [p = (0.1, 0)[m]] },
    ],
    joints: [orbit = free(seat), rope = lnk(world(0, 0), seat.p, 2[m])],
});

// the axis of a screw that closes a loop is made of numbers
rigid_system!(Thread {
    params: [slope = 0.3],
    bodies: [
        base { mass: 1[kg], inertia: sphere(1[m]) },
        nut { mass: 1[kg], inertia: sphere(1[m]) },
    ],
    joints: [
        orbit = free(base),
        sleeve = spherical(base.G, nut.G),
        thread = screw(base.G, nut.G, body(1, slope, 0), 0.1[m]),
        other = screw(base.G, nut.G, body(1, 0, 0), 0[m]),
    ],
});

fn main() {}
