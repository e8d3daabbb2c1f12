//! Point masses and rods on hinges: their inertia about the hinge is that of their mass.

use newton_euler::prelude::*;

rigid_system!(Points {
    doc: "The double pendulum of the textbooks: two point masses on massless arms.",
    motion: planar,
    bodies: [
        first {
            mass: 2[kg],
            inertia: 0[kg * m ^ 2],
            points: [pin = (0, 0.7)[m]]
        },
        second {
            mass: 0.5[kg],
            inertia: 0[kg * m ^ 2],
            points: [pin = (0, 0.4)[m]]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), first.pin),
        elbow = revolute(first.G, second.pin),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [energy, mass_matrix, reactions],
});

rigid_system!(InSpace {
    doc: "The same in space.",
    bodies: [
        first {
            mass: 2[kg],
            inertia: principal(0, 0, 0)[kg * m ^ 2],
            points: [pin = (0, 0.7, 0)[m]]
        },
        second {
            mass: 0.5[kg],
            inertia: principal(0, 0, 0)[kg * m ^ 2],
            points: [pin = (0, 0.4, 0)[m]]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0, 0), first.pin, body(0, 0, 1)),
        elbow = revolute(first.G, second.pin, body(0, 0, 1)),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2], 0)],
});

rigid_system!(Rods {
    doc: "A rod on a hinge across it, and a rod on that one, about another axis.",
    bodies: [
        upper {
            mass: 2[kg],
            inertia: rod(1[m]).along(body(0, 1, 0)),
            points: [pin = (0, 0.5, 0), tip = (0, -0.5, 0)]
        },
        lower {
            mass: 1[kg],
            inertia: rod(0.6[m]).along(body(0, 1, 0)),
            points: [pin = (0, 0.3, 0)]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0, 0), upper.pin, body(0, 0, 1)),
        elbow = revolute(upper.tip, lower.pin, body(1, 0, 0)),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2], 0)],
    outputs: [energy],
});

/// `M q'' = f` of two point masses, with the angles of both arms from the vertical.
fn textbook(first: [f64; 2], second: [f64; 2]) -> [f64; 2] {
    let ([m1, m2], [l1, l2], g) = ([2.0, 0.5], [0.7, 0.4], 9.81);
    let ([a, u], [b, v]) = (first, second);
    let (sine, cosine) = (a - b).sin_cos();
    let rows = [[(m1 + m2) * l1, m2 * l2 * cosine], [l1 * cosine, l2]];
    let right = [
        -m2 * l2 * v * v * sine - (m1 + m2) * g * a.sin(),
        l1 * u * u * sine - g * b.sin(),
    ];
    let determinant = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
    [
        (right[0] * rows[1][1] - right[1] * rows[0][1]) / determinant,
        (rows[0][0] * right[1] - rows[1][0] * right[0]) / determinant,
    ]
}

#[test]
fn the_double_pendulum_of_the_textbooks() {
    for step in 0..12 {
        let turn = f64::from(step);
        let shoulder = Hinge {
            angle: 0.5 * turn - 2.0,
            angular_velocity: 1.0 - 0.2 * turn,
        };
        let elbow = Hinge {
            angle: 0.3 * turn - 1.0,
            angular_velocity: 0.4 * turn - 2.0,
        };
        let first = [shoulder.angle, shoulder.angular_velocity];
        let second = [
            shoulder.angle + elbow.angle,
            shoulder.angular_velocity + elbow.angular_velocity,
        ];
        let [a, b] = textbook(first, second);
        let found = Points::default().acceleration(0.0, &PointsState { shoulder, elbow }, &());
        assert!((found.shoulder - a).abs() < 1e-12 && (found.elbow - (b - a)).abs() < 1e-12);
        let found = InSpace::default().acceleration(0.0, &InSpaceState { shoulder, elbow }, &());
        assert!((found.shoulder - a).abs() < 1e-12 && (found.elbow - (b - a)).abs() < 1e-12);
    }
}

#[test]
fn rods_keep_their_energy() {
    let rods = Rods::default();
    let start = RodsState {
        shoulder: Hinge {
            angle: 0.7,
            angular_velocity: 1.0,
        },
        elbow: Hinge {
            angle: -0.4,
            angular_velocity: 2.0,
        },
    };
    let energy =
        |state: &RodsState| rods.kinetic_energy(state) + rods.potential_energy(0.0, state, &());
    let end = rods.integrate(&start).tolerance(1e-12).to(3.0).unwrap();
    assert!((energy(&end) - energy(&start)).abs() < 1e-9);
    // at rest, hanging: of a rod of length l about its end, 3 g / 2 l
    let still = RodsState {
        elbow: Hinge {
            angle: 1e-3,
            angular_velocity: 0.0,
        },
        ..RodsState::default()
    };
    let found = rods.acceleration(0.0, &still, &());
    assert!((found.elbow / (-1.5 * 9.81 / 0.6 * f64::sin(1e-3)) - 1.0).abs() < 1e-9);
}
