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

/// A rod of 1 kg and 1 m with a bob of 2 kg at its end, on a hinge at the other end.
macro_rules! rod_with_bob {
    ($system:ident $body:ident [$($params:tt)*] $inertia:expr, $pin:expr, [$($mass:tt)*]) => {
        rigid_system!($system {
            params: [$($params)*],
            bodies: [
                arm { $($mass)* inertia: $inertia, points: [pin = ($pin, 0, 0)] },
            ],
            joints: [hinge = revolute(world(0, 0, 0), arm.pin, body(0, 0, 1))],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2], 0)],
        });
        rigid_body!($body {
            motion: fixed_axis(pin, world(0, 0, 1)),
            params: [$($params)*],
            $($mass)*
            inertia: $inertia,
            points: [pin = ($pin, 0, 0)],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2], 0)],
        });
    };
}
rod_with_bob!(Parts PartsAlone [] compose([
    rod(1[m]).along(body(1, 0, 0)).mass(1[kg]).at((0.5, 0, 0)[m]),
    point(2[kg]).at((1, 0, 0)[m]),
]), 0, []);
rod_with_bob!(PartsOfParams PartsOfParamsAlone [l = 1[m], bob = 2[kg]] compose([
    rod(l).along(body(1, 0, 0)).mass(1[kg]).at((0.5 * l, 0, 0)),
    point(bob).at((l, 0, 0)),
]), 0, []);
rod_with_bob!(Numbers NumbersAlone [] principal(0, 0.25, 0.25)[kg * m ^ 2], -5 / 6, [mass: 3[kg],]);
rod_with_bob!(Entries EntriesAlone [least = 0[kg * m ^ 2], j = 0.25[kg * m ^ 2]]
    principal(least, j, j), -5 / 6, [mass: 3[kg],]);

#[test]
fn rods_with_bobs_swing() {
    let expected = -9.81 * (0.5 + 2.0) / (1.0 / 3.0 + 2.0);
    macro_rules! check {
        ($($system:ident $state:ident $body:ident),+) => {$(
            let found = $system::default().acceleration(0.0, &$state::default(), &()).hinge;
            assert!((found - expected).abs() < 1e-14, "{}: {found}", stringify!($system));
            let found = $body::default().acceleration(0.0, &Hinge::default(), &());
            assert!((found - expected).abs() < 1e-14, "{}: {found}", stringify!($body));
        )+};
    }
    check!(
        Parts PartsState PartsAlone,
        PartsOfParams PartsOfParamsState PartsOfParamsAlone,
        Numbers NumbersState NumbersAlone,
        Entries EntriesState EntriesAlone
    );
    // one moment that is negative, or larger than the other two together, is still refused
    for (least, j) in [(-1e-3, 0.25), (0.6, 0.25)] {
        assert!(Entries::new(EntriesParams { least, j }).is_err());
        assert!(EntriesAlone::new(EntriesAloneParams { least, j }).is_err());
    }
}

rigid_body!(Bob {
    doc: "A point mass by its parts, in the plane.",
    motion: pivot(pin),
    params: [l = 0.5[m]],
    inertia: compose([point(2[kg]).at((l, 0))]),
    points: [pin = (0, 0)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
});

#[test]
fn a_bob_swings() {
    for l in [0.5, 1e-3, 7.0] {
        let found = Bob::new(BobParams { l })
            .unwrap()
            .acceleration(0.0, &Hinge::default(), &());
        assert!((found * l / -9.81 - 1.0).abs() < 1e-14, "{l}: {found}");
    }
}
