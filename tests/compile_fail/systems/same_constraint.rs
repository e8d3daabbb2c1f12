use newton_euler::rigid_system;

rigid_system!(Swing {
    motion: planar,
    bodies: [seat {
        mass: 30[kg],
        inertia: 2[kg * m ^ 2],
        points: [left = (-0.2, 0)[m], right = (0.2, 0)[m]],
    }],
    joints: [
        swings = free(seat),
        rope = link(world(-0.2, 2)[m], seat.left, 2[m]),
        rope = link(world(0.2, 2)[m], seat.right, 2[m]),
    ],
});

rigid_system!(Gears {
    motion: planar,
    bodies: [
        sun { mass: 1[kg], inertia: 0.1[kg * m ^ 2] },
        planet { mass: 1[kg], inertia: 0.1[kg * m ^ 2] },
    ],
    joints: [shaft = revolute(world(0, 0), sun.G), axle = revolute(world(1, 0), planet.G)],
    constraints: [mesh = shaft.angle + 2 * axle.angle, mesh = shaft.angle - 1],
});

fn main() {}
