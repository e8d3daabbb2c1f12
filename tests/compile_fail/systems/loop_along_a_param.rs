use newton_euler::rigid_system;

rigid_system!(Tilted {
    params: [tilt],
    bodies: [
        crank { mass: 1[kg], inertia: principal(1, 1, 1), points: [o = (0, 0, 0), a = (0.3, 0.4, 0)] },
        rod { mass: 1[kg], inertia: principal(1, 1, 1), points: [b = (0.6, 0.8, 0)] },
    ],
    joints: [
        o = spherical(world(0, 0, 0), crank.o),
        a = spherical(crank.a, rod.G),
        b = revolute(world(1, 0, 0), rod.b, body(1, tilt, 0)),
    ],
});

fn main() {}
