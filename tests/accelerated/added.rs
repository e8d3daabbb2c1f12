//! Loads that resist accelerations in systems: where they are proved to add an inertia that is not
//! negative, the equations are solved with it; all others must give the same.

use newton_euler::operations::Operations;
use newton_euler::prelude::*;

use crate::Random;

/// The operations of a function in a state.
fn cost(operations: &[Operations], function: &str) -> u32 {
    let rows = operations.iter().filter(|row| row.function == function);
    rows.map(|row| row.mul + row.add + row.div + row.sqrt).sum()
}

/// A diver with an arm, of which each body is in water.
macro_rules! diver {
    ($name:ident [$($params:tt)*] $hull:expr, $across:expr, $lower:expr, $hand:expr) => {
        rigid_system!($name {
            params: [$($params)*],
            inputs: [first[N * m], second[N * m], third[N * m]],
            bodies: [
                hull {
                    mass: 12[kg],
                    inertia: principal(0.8, 1.1, 1.7)[kg * m ^ 2],
                    points: [shoulder = (0.3, 0, -0.1), fin = (-0.4, 0.1, 0)],
                    forces: [
                        added = -$hull * acceleration,
                        flat = (-$across * body(0, 1, 0) * fin.acceleration().dot(body(0, 1, 0))).at(fin),
                    ],
                },
                upper {
                    mass: 2[kg],
                    inertia: principal(0.02, 0.05, 0.05)[kg * m ^ 2],
                    points: [a = (-0.2, 0, 0), b = (0.2, 0, 0)],
                },
                lower {
                    mass: 1[kg],
                    inertia: principal(0.01, 0.02, 0.02)[kg * m ^ 2],
                    points: [a = (-0.2, 0, 0), b = (0.2, 0, 0)],
                    forces: [added = -$lower * acceleration],
                },
                hand {
                    mass: 0.5[kg],
                    inertia: principal(0.001, 0.002, 0.002)[kg * m ^ 2],
                    points: [a = (-0.1, 0, 0)],
                    forces: [added = -$lower * acceleration],
                    moments: [turned = -$hand * angular_acceleration],
                },
            ],
            joints: [
                swim = free(hull),
                first_joint = revolute(hull.shoulder, upper.a, body(0, 0, 1)),
                second_joint = revolute(upper.b, lower.a, body(0, 1, 0)),
                third_joint = revolute(lower.b, hand.a, body(1, 0, 0)),
            ],
            fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
            drives: [
                a = first.on(first_joint),
                b = second.on(second_joint),
                c = third.on(third_joint),
            ],
            outputs: [linearization],
        });
    };
}
diver!(Diver [] 3[kg], 1.5[kg], 0.75[kg], 0.0015[kg * m ^ 2]);
// nothing is claimed if more inertia is taken away by default than there is
diver!(Unknown [of_hull = -30[kg], of_across = 0[kg], of_lower[kg], of_hand[kg * m ^ 2]]
    of_hull, of_across, of_lower, of_hand);
// the sign of parameters is checked by `new`
diver!(Checked [of_hull[kg], of_across[kg], of_lower[kg], of_hand[kg * m ^ 2]]
    of_hull, of_across, of_lower, of_hand);
diver!(Dry [] 0[kg], 0[kg], 0[kg], 0[kg * m ^ 2]);

/// The same state of four types.
macro_rules! in_state {
    ($drawn:ident, $state:ident) => {
        $state {
            swim: $drawn.swim,
            first_joint: $drawn.first_joint,
            second_joint: $drawn.second_joint,
            third_joint: $drawn.third_joint,
        }
    };
}

fn drawn(random: &mut Random) -> DiverState {
    let mut hinge = || Hinge {
        angle: 3.0 * random.next(),
        angular_velocity: random.next(),
    };
    let [first_joint, second_joint, third_joint] = [hinge(), hinge(), hinge()];
    DiverState {
        swim: random.spatial(),
        first_joint,
        second_joint,
        third_joint,
    }
}

#[test]
fn what_is_solved_with_added_inertia_is_right() {
    let mut random = Random(31);
    let diver = Diver::default();
    let unknown = Unknown::new(UnknownParams {
        of_hull: 3.0,
        of_across: 1.5,
        of_lower: 0.75,
        of_hand: 0.0015,
    })
    .unwrap();
    let checked = Checked::new(CheckedParams {
        of_hull: 3.0,
        of_across: 1.5,
        of_lower: 0.75,
        of_hand: 0.0015,
    })
    .unwrap();
    for _ in 0..20 {
        let state = drawn(&mut random);
        let [first, second, third] = [random.next(), random.next(), random.next()];
        let input = DiverInput {
            first,
            second,
            third,
        };
        let found = diver.acceleration(0.0, &state, &input);
        let expected = unknown.acceleration(
            0.0,
            &in_state!(state, UnknownState),
            &UnknownInput {
                first,
                second,
                third,
            },
        );
        let by_value = checked.acceleration(
            0.0,
            &in_state!(state, CheckedState),
            &CheckedInput {
                first,
                second,
                third,
            },
        );
        let size = found.first_joint.abs() + found.second_joint.abs() + found.third_joint.abs();
        for (one, other) in [
            (
                expected.swim,
                [
                    expected.first_joint,
                    expected.second_joint,
                    expected.third_joint,
                ],
            ),
            (
                by_value.swim,
                [
                    by_value.first_joint,
                    by_value.second_joint,
                    by_value.third_joint,
                ],
            ),
        ] {
            assert!((found.swim.linear - one.linear).amax() < 1e-12 * (10.0 + size));
            assert!((found.swim.angular - one.angular).amax() < 1e-12 * (10.0 + size));
            let found = [found.first_joint, found.second_joint, found.third_joint];
            for (found, other) in found.iter().zip(other) {
                assert!(
                    (found - other).abs() < 1e-12 * (10.0 + size),
                    "{found} {other}"
                );
            }
        }
        let found = diver.linearize(0.0, &state, &input);
        let input = UnknownInput {
            first,
            second,
            third,
        };
        let expected = unknown.linearize(0.0, &in_state!(state, UnknownState), &input);
        let size = 1.0 + expected.a().amax();
        assert!((found.a() - expected.a()).amax() < 1e-11 * size);
        assert!((found.b() - expected.b()).amax() < 1e-11 * size);
    }
}

/// The equations of the dry diver take as many operations, with a quarter to a half more.
#[test]
fn added_inertia_costs_little() {
    let costs = [Dry::OPERATIONS, Diver::OPERATIONS, Checked::OPERATIONS]
        .map(|of| ["acceleration", "linearize"].map(|function| cost(of, function)));
    let bounds = [[511, 3595], [652, 5241], [765, 5423]];
    for (costs, bounds) in costs.into_iter().zip(bounds) {
        assert!(costs[0] <= bounds[0] && costs[1] <= bounds[1], "{costs:?}");
    }
}

/// Added mass may be negative, down to the mass of the body; beyond, `new` says so.
#[test]
fn parameters_that_take_inertia_away_are_errors() {
    let with = |of_hull: f64, of_hand: f64| {
        Checked::new(CheckedParams {
            of_hull,
            of_across: 0.1,
            of_lower: 0.0,
            of_hand,
        })
    };
    assert!(with(-10.0, 0.0).is_ok());
    for (of_hull, of_hand, said) in [
        (
            -12.5,
            0.0,
            "the inertia with added mass of `hull` cannot be -0.5",
        ),
        (
            1.0,
            -1.0,
            "the inertia with added mass of `hand` cannot be -0.999",
        ),
    ] {
        let error = with(of_hull, of_hand).expect_err("an error").to_string();
        assert_eq!(error, said);
    }
    assert!(with(f64::NAN, 0.0).is_err());
    let error = Cart::new(CartParams {
        amount: -1.0,
        ..CartParams::default()
    });
    let said = error.expect_err("an error").to_string();
    assert_eq!(said, "the added mass of `float` cannot be -0.2");
}

rigid_system!(Bubble {
    bodies: [air {
        mass: 0.000001[kg],
        inertia: principal(1, 2, 2)[kg * m ^ 2],
        forces: [water = -1[kg] * acceleration],
    }],
    joints: [floats = free(air)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});

/// A body whose water is a million times as heavy as itself does not fall with it.
#[test]
fn light_bodies_in_water_lose_no_digits() {
    let floats = Random(33).spatial();
    let found = Bubble::default().acceleration(0.0, &BubbleState { floats }, &());
    let expected = -9.81e-6 / (1.0 + 1e-6);
    assert!((found.floats.linear.z / expected - 1.0).abs() < 1e-15);
    assert!(found.floats.linear.xy().amax() < 1e-20);
}

/// A buoy with parameters.
macro_rules! buoy {
    ($name:ident [$($params:tt)*] $radius:expr, $mass:expr) => {
        rigid_system!($name {
            params: [$($params)*],
            bodies: [
                hull {
                    mass: $mass,
                    inertia: principal(1, 1.5, 2)[kg * m ^ 2],
                    points: [fin = ($radius, 0.2, 0.3), top = (0.1, 0, 0)],
                    forces: [at_fin = (-1[kg] * fin.acceleration()).at(fin)],
                    moments: [
                        turned = -mass * $radius.powi(2) * angular_acceleration,
                        across = -mass * $radius.powi(2) * body(1, 0, 1)
                            * angular_acceleration.dot(body(1, 0, 1)),
                    ],
                },
                mast {
                    mass: 1[kg],
                    inertia: principal(1, 1, 1)[kg * m ^ 2],
                    points: [foot = (0, 0.1, 0)],
                },
            ],
            joints: [
                floats = free(hull),
                sways = revolute(hull.top, mast.foot, body(0, 0, 1)),
            ],
            fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
        });
    };
}
buoy!(Buoy [] 0.4[m], 3[kg]);
buoy!(AnyBuoy [radius[m], own[kg]] radius, own);

#[test]
fn squares_and_points_have_signs() {
    let mut random = Random(34);
    let (one, any) = (
        Buoy::default(),
        AnyBuoy::new(AnyBuoyParams {
            radius: 0.4,
            own: 3.0,
        })
        .unwrap(),
    );
    for _ in 0..10 {
        let (floats, angle, angular_velocity) = (random.spatial(), random.next(), random.next());
        let sways = Hinge {
            angle,
            angular_velocity,
        };
        let found = one.acceleration(0.0, &BuoyState { floats, sways }, &());
        let expected = any.acceleration(0.0, &AnyBuoyState { floats, sways }, &());
        assert!((found.floats.linear - expected.floats.linear).amax() < 1e-13);
        assert!((found.floats.angular - expected.floats.angular).amax() < 1e-13);
        assert!((found.sways - expected.sways).abs() < 1e-13);
    }
    let costs = [Buoy::OPERATIONS, AnyBuoy::OPERATIONS].map(|of| cost(of, "acceleration"));
    assert!(costs[0] <= 289 && costs[1] <= 289, "{costs:?}");
}

/// A pendulum of 2 kg, at 0.5 m, whose moment of inertia about G is 0.1 kg m^2.
macro_rules! pendulum {
    ($name:ident [$($force:tt)*] [$($drive:tt)*]) => {
        rigid_system!($name {
            motion: planar,
            bodies: [arm {
                mass: 2[kg],
                inertia: 0.1[kg * m ^ 2],
                points: [top = (0, 0.5)],
                forces: [water = $($force)*],
            }],
            joints: [hinge = revolute(world(0, 0), arm.top)],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
            drives: [rotor = ($($drive)*).on(hinge)],
        });
    };
}
pendulum!(AlongWorld[-0.5[kg] * world(1, 0) * acceleration.dot(world(1, 0))][0[N * m]]);
pendulum!(Pushed[0.4[kg] * acceleration][0[N * m]]);
pendulum!(
    Skew[-body(
        0.5[kg] * acceleration.in_body().x + 0.3[kg] * acceleration.in_body().y,
        0.5[kg] * acceleration.in_body().y - 0.3[kg] * acceleration.in_body().x
    )][0[N * m]]
);
pendulum!(Helped[-0.5[kg] * acceleration][0.01[kg * m ^ 2] * hinge.angular_acceleration]);
// the step is one of the velocity here, and of the acceleration for another joint
pendulum!(
    Stepped[body(
        -0.5[kg] * acceleration.in_body().x
            + 1[N] * (20[s ^ 2 / m] * acceleration.in_body().y).floor(),
        0
    )][0[N * m]]
);
// more is added than is taken away
pendulum!(
    Both[-0.5[kg] * acceleration + 0.2[kg] * acceleration]
        [-0.01[kg * m ^ 2] * hinge.angular_acceleration]
);

#[test]
fn loads_that_are_no_inertia_are_right_too() {
    let mut random = Random(32);
    for _ in 0..20 {
        let (angle, w) = (3.0 * random.next(), random.next());
        let (sine, cosine) = angle.sin_cos();
        let (radius, weight) = (0.5, -2.0 * 9.81 * 0.5 * sine);
        let inertia = 0.1 + 2.0 * radius * radius;
        let hinge = Hinge {
            angle,
            angular_velocity: w,
        };
        let swung = radius * radius * w * w;
        let along_world =
            (weight + 0.5 * cosine * sine * swung) / (inertia + 0.5 * (radius * cosine).powi(2));
        let all = [
            (
                AlongWorld::default()
                    .acceleration(0.0, &AlongWorldState { hinge }, &())
                    .hinge,
                along_world,
            ),
            (
                Pushed::default()
                    .acceleration(0.0, &PushedState { hinge }, &())
                    .hinge,
                weight / (inertia - 0.4 * radius * radius),
            ),
            (
                Skew::default()
                    .acceleration(0.0, &SkewState { hinge }, &())
                    .hinge,
                (weight - 0.3 * swung) / (inertia + 0.5 * radius * radius),
            ),
            (
                Stepped::default()
                    .acceleration(0.0, &SteppedState { hinge }, &())
                    .hinge,
                (weight + radius * (20.0 * radius * w * w).floor())
                    / (inertia + 0.5 * radius * radius),
            ),
            (
                Helped::default()
                    .acceleration(0.0, &HelpedState { hinge }, &())
                    .hinge,
                weight / (inertia + 0.5 * radius * radius - 0.01),
            ),
            (
                Both::default()
                    .acceleration(0.0, &BothState { hinge }, &())
                    .hinge,
                weight / (inertia + 0.3 * radius * radius + 0.01),
            ),
        ];
        for (number, (found, expected)) in all.into_iter().enumerate() {
            assert!(
                (found - expected).abs() < 1e-13 * (1.0 + expected.abs()),
                "{number}"
            );
        }
    }
}

/// A cart on a plane with a hinge, and a float along it: squared lengths of columns that depend on
/// params have values with long fractions, and what cancels in them is not proved to be zero.
macro_rules! cart {
    ($name:ident $default:expr) => {
        rigid_system!($name {
            params: [m0 = 1.2[kg], amount = $default],
            bodies: [
                cart {
                    mass: 1.91[kg],
                    inertia: principal(0.1453, 0.1527, 0.1307)[kg * m ^ 2],
                    points: [q = (0.3, 0.47, 0), e = (0, 0, 0)],
                },
                float {
                    mass: 0.586[kg],
                    points: [p = (0.25, 0, 0)],
                    forces: [added =
                        (-amount * 0.2[kg] * body(1, 2, 2) * p.acceleration().dot(body(1, 2, 2)))
                            .at(p)],
                },
                rotor {
                    mass: 2.88[kg],
                    inertia: principal(0.2695, 0.0592, 0.2492)[kg * m ^ 2]
                },
                flap {
                    mass: m0,
                    inertia: principal(0.1397, 0.2216, 0.2190)[kg * m ^ 2],
                    points: [q = (0, 0.21, 0)],
                },
            ],
            joints: [
                slides = planar(world(0, 0, 0), cart.q, body(0, 1, 0)),
                floats = translation(float),
                spins = revolute(cart.G, rotor.G, body(0, 0, 1)).driven((2[1 / s] * t).sin()),
                turns = revolute(cart.e, flap.q, body(1, 0, 0))
                    .turned(body(1, 0, 0), 0.234[rad])
                    .armature(0.05[kg * m ^ 2]),
            ],
            fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
            outputs: [reactions],
        });
    };
}
cart!(Cart 1.0);
// nothing is claimed if inertia is taken away by default
cart!(AnyCart - 50.0);

#[test]
fn what_cancels_in_defaults_is_no_error() {
    let mut random = Random(34);
    let params = AnyCartParams {
        amount: 1.0,
        ..AnyCartParams::default()
    };
    let (one, any) = (Cart::default(), AnyCart::new(params).unwrap());
    for _ in 0..20 {
        let mut state = CartState::default();
        state.slides.angle = random.next();
        state.slides.angular_velocity = random.next();
        state.floats.velocity.x = random.next();
        state.turns = Hinge {
            angle: random.next(),
            angular_velocity: random.next(),
        };
        let same = AnyCartState {
            slides: state.slides,
            floats: state.floats,
            turns: state.turns,
        };
        let expected = one.acceleration(0.3, &state, &());
        let found = any.acceleration(0.3, &same, &());
        assert!((found.slides.linear - expected.slides.linear).amax() < 1e-13);
        assert!((found.slides.angular - expected.slides.angular).abs() < 1e-13);
        assert!((found.floats - expected.floats).amax() < 1e-13);
        assert!((found.turns - expected.turns).abs() < 1e-13);
    }
    let costs = [Cart::OPERATIONS, AnyCart::OPERATIONS].map(|of| cost(of, "acceleration"));
    assert!(costs[0] < costs[1], "{costs:?}");
}
