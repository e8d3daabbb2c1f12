use newton_euler::rigid_system;

rigid_system!(Swing {
    motion: planar,
    bodies: [
        seat { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [p = (0.1, 0)[m]] },
    ],
    joints: [orbit = free(seat), rope = lnk(world(0, 0), seat.p, 2[m])],
});

rigid_system!(Thread {
    bodies: [
        base { mass: 1[kg], inertia: sphere(1[m]) },
        nut { mass: 1[kg], inertia: sphere(1[m]) },
    ],
    joints: [
        orbit = free(base),
        sleeve = spherical(base.G, nut.G),
        other = screw(base.G, nut.G, body(1, 0, 0), 0[m]),
    ],
});

fn main() {}
