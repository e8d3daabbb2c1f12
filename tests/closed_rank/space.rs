//! Linkages in space that move although they have as many rows as joints, or more.

use newton_euler::prelude::*;

// Sarrus' linkage: two chains of three parallel hinges, across each other, hold a plate that goes up and
// down. One of five rows says nothing, in all states; but where links are folded, others do neither
rigid_system!(Sarrus {
    bodies: [
        lower_a {
            mass: 1[kg],
            inertia: principal(0.1, 0.12, 0.05)[kg * m ^ 2],
            points: [o = (0, 0, -0.5), e = (0, 0, 0.5)]
        },
        upper_a {
            mass: 1.2[kg],
            inertia: principal(0.11, 0.14, 0.06)[kg * m ^ 2],
            points: [e = (0, 0, -0.5), f = (0, 0, 0.5)]
        },
        plate {
            mass: 3[kg],
            inertia: principal(0.4, 0.5, 0.8)[kg * m ^ 2],
            points: [a = (-0.5, 0, 0), b = (0.5, 0, 0)]
        },
        upper_b {
            mass: 0.8[kg],
            inertia: principal(0.09, 0.1, 0.03)[kg * m ^ 2],
            points: [e = (0, 0, -0.5), f = (0, 0, 0.5)]
        },
        lower_b {
            mass: 0.7[kg],
            inertia: principal(0.08, 0.07, 0.02)[kg * m ^ 2],
            points: [o = (0, 0, -0.5), e = (0, 0, 0.5)]
        },
    ],
    joints: [
        o = revolute(world(0, 0, 0), lower_a.o, world(0, 1, 0)),
        a = revolute(lower_a.e, upper_a.e, body(0, 1, 0)),
        b = revolute(upper_a.f, plate.a, body(0, 1, 0)),
        c = revolute(plate.b, upper_b.f, body(1, 0, 0)),
        d = revolute(upper_b.e, lower_b.e, body(1, 0, 0)),
        e = revolute(world(1, 0, 0), lower_b.o, world(1, 0, 0)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});

/// Lower links lean by this angle, and upper ones back.
fn leaning(angle: f64, rate: f64) -> SarrusState {
    let hinge = |times: f64| Hinge {
        angle: times * angle,
        angular_velocity: times * rate,
    };
    SarrusState {
        o: hinge(-1.0),
        a: hinge(2.0),
        b: hinge(-1.0),
        c: hinge(1.0),
        d: hinge(-2.0),
    }
}

/// Inertia for the angle, and its derivative; the plate is at `2 cos`, upper links at `1.5 cos` and
/// `0.5 sin`.
fn inertia(angle: f64) -> (f64, f64) {
    let (sin, cos) = angle.sin_cos();
    let turning = 0.12 + 0.14 + 0.09 + 0.08 + 0.25 * (1.0 + 0.7);
    let moving = (1.2 + 0.8) * (0.25 * cos * cos + 2.25 * sin * sin) + 4.0 * 3.0 * sin * sin;
    let slope = ((1.2 + 0.8) * 4.0 + 8.0 * 3.0) * sin * cos;
    (turning + moving, slope)
}

const WEIGHT: f64 = 9.81 * (0.5 * (1.0 + 0.7) + 1.5 * (1.2 + 0.8) + 2.0 * 3.0);

#[test]
fn a_plate_goes_down() {
    let body = Sarrus::default();
    for number in 1..30 {
        let angle = 0.05 * f64::from(number);
        for rate in [0.0, -1.3] {
            let mut state = leaning(angle, rate);
            body.check(0.0, &state, &()).unwrap();
            for is_projected in [false, true] {
                if is_projected {
                    state.a.angle += 1e-4;
                    state.c.angle -= 1e-4;
                    body.project(0.0, &mut state, &()).unwrap();
                }
                let (angle, rate) = (-state.o.angle, -state.o.angular_velocity);
                let (inertia, slope) = inertia(angle);
                let expected = (WEIGHT * angle.sin() - 0.5 * slope * rate * rate) / inertia;
                let found = body.acceleration(0.0, &state, &());
                let all = [-found.o, 0.5 * found.a, -found.b, found.c, -0.5 * found.d];
                for one in all {
                    let error = (one - expected).abs();
                    assert!(
                        error < 1e-10,
                        "{angle} {rate} {is_projected}: {found:?} {expected}"
                    );
                }
            }
        }
    }
}

#[test]
fn energy_is_kept() {
    let energy = |state: &SarrusState| {
        let (angle, rate) = (-state.o.angle, -state.o.angular_velocity);
        0.5 * inertia(angle).0 * rate * rate + WEIGHT * angle.cos()
    };
    let start = leaning(0.9, -2.0);
    let end = Sarrus::default().integrate(&start).to(0.8).unwrap();
    let [before, after] = [&start, &end].map(energy);
    assert!(
        (after - before).abs() < 1e-8 * before,
        "{before} {after} {end:?}"
    );
}

// Bennett's linkage, of links of 1 and 0.6 m, twisted by a right angle and by one whose sine is 0.6
macro_rules! bennetts {
    ($name:ident, [$($body:tt)*], [$($joint:tt)*]) => {
        rigid_system!($name {
            bodies: [
                one {
                    mass: 1[kg],
                    inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
                    points: [a = (0, 0, 0), b = (1, 0, 0)]
                },
                two {
                    mass: 1.5[kg],
                    inertia: principal(0.2, 0.2, 0.3)[kg * m ^ 2],
                    points: [b = (0, 0, 0), c = (0.6, 0, 0)]
                },
                three {
                    mass: 0.7[kg],
                    inertia: principal(0.12, 0.1, 0.2)[kg * m ^ 2],
                    points: [c = (0, 0, 0), d = (-1, 0, 0)]
                },
                $($body)*
            ],
            joints: [
                a = revolute(world(0, 0, 0), one.a, world(0, 0, 1)),
                b = revolute(one.b, two.b, body(0, -1, 0)),
                c = revolute(two.c, three.c, body(0, -0.8, -0.6)),
                d = revolute(world(0.6, 0, 0), three.d, world(0, -0.6, 0.8)),
                $($joint)*
            ],
            fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
            outputs: [energy],
        });
    };
}

bennetts!(Bennett, [], []);

// beside it, a body that two slides hold: two rows are multiples of each other
bennetts!(
    Beside,
    [block {
        mass: 0.5[kg],
        inertia: principal(0.3, 0.3, 0.4)[kg * m ^ 2]
    }],
    [
        slide = prismatic(world(0, 0, 0), block.G, body(2, -1, 2)),
        held = prismatic(world(0, 0, 0), block.G, body(1, 0, 0)),
    ]
);

// opposite angles are alike, and half of a neighbor has a tangent of twice that of half of the other
fn bent(angle: f64, rate: f64) -> BennettState {
    let hinge = |angle, angular_velocity| Hinge {
        angle,
        angular_velocity,
    };
    let half = (0.5 * angle).tan();
    let other = 2.0 * (1.0 + half * half) / (1.0 + 4.0 * half * half);
    BennettState {
        a: hinge(angle, rate),
        b: hinge(2.0 * (2.0 * half).atan(), other * rate),
        c: hinge(-angle, -rate),
    }
}

// it has one way to move: its energy tells how
#[test]
fn bennetts_linkage_keeps_its_energy() {
    let body = Bennett::default();
    let energy = |state: &BennettState| {
        let potential = body.potential_energy(0.0, state, &());
        body.kinetic_energy(state) + potential
    };
    for number in 1..10 {
        let angle = 0.3 * f64::from(number);
        let start = bent(angle, 2.0);
        body.check(0.0, &start, &()).unwrap();
        let mut moved = start;
        moved.b.angle += 1e-2;
        moved.c.angular_velocity += 0.1;
        body.project(0.0, &mut moved, &()).unwrap();
        let near = bent(moved.a.angle, moved.a.angular_velocity);
        assert!((near.b.angle - moved.b.angle).abs() < 1e-12, "{moved:?}");
        let end = body.integrate(&start).to(0.5).unwrap();
        let [before, after] = [&start, &end].map(energy);
        assert!((after - before).abs() < 1e-9 * before, "{before} {after}");
    }
}

#[test]
fn a_held_body_beside_it_changes_nothing() {
    let (alone, both) = (Bennett::default(), Beside::default());
    for number in 1..10 {
        let start = bent(0.3 * f64::from(number), 2.0);
        let BennettState { a, b, c } = start;
        let slide = Slide::default();
        let state = BesideState { a, b, c, slide };
        let expected = alone.acceleration(0.0, &start, &());
        let found = both.acceleration(0.0, &state, &());
        let pairs = [
            (found.a, expected.a),
            (found.b, expected.b),
            (found.c, expected.c),
            (found.slide, 0.0),
        ];
        for (found, expected) in pairs {
            assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        }
        both.integrate(&state).to(0.1).unwrap();
    }
}
