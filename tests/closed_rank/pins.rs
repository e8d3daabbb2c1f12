//! Bodies that are held to others in more places than needed, on carriers that move.

use newton_euler::nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

/// Two bodies on a hinge, held to each other by two joints.
macro_rules! pair {
    ($name:ident $first:expr, $second:expr) => {
        rigid_system!($name {
            bodies: [
                a {
                    mass: 1.5[kg],
                    inertia: sphere(0.1),
                    points: [o = (1, 0, 0), _h = (0.2, 0, 0.1), _k = (0.2, 0.1, 0.1)]
                },
                b {
                    mass: 0.5[kg],
                    inertia: sphere(0.2),
                    points: [_h = (0.2, 0, 0.1), _k = (0.2, 0.1, 0.1)]
                },
            ],
            joints: [
                swing = revolute(world(0, 0, 0), a.o, world(0, 1, 0)),
                first = $first,
                second = $second,
            ],
            fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
        });
    };
}
pair!(Hinges revolute(a.G, b.G, body(0, 0, 1)), revolute(a._h, b._h, body(0, 0, 1)));
pair!(Askew revolute(a.G, b.G, body(0, 0, 1)), revolute(a._k, b._k, body(0, 0, 1)));
pair!(Welded revolute(a.G, b.G, body(0, 0, 1)), weld(a._h, b._h));
pair!(BallAndWeld spherical(a.G, b.G), weld(a._k, b._k));

rigid_system!(Pins {
    motion: planar,
    bodies: [
        a {
            mass: 1.5[kg],
            inertia: 0.006[kg * m ^ 2],
            points: [o = (1, 0), _h = (0.2, 0)]
        },
        b {
            mass: 0.5[kg],
            inertia: 0.008[kg * m ^ 2],
            points: [_h = (0.2, 0)]
        },
    ],
    joints: [
        swing = revolute(world(0, 0), a.o),
        first = revolute(a.G, b.G),
        second = revolute(a._h, b._h),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
});

#[test]
fn two_bodies_swing_as_one() {
    // solid spheres of both radii at one place, 1 m off the axis
    let inertia = 0.4 * (1.5 * 0.01 + 0.5 * 0.04) + 2.0;
    for (angle, angular_velocity) in [(0.0, 0.0), (0.4, 0.3), (-1.1, 10.0), (2.0, 1e-3)] {
        let swing = Hinge {
            angle,
            angular_velocity,
        };
        let falls = 2.0 * 9.81 * f64::cos(angle) / inertia;
        macro_rules! check {
            ($name:ident $state:ident, $expected:expr) => {
                let state = $state {
                    swing,
                    ..$state::default()
                };
                $name::default().check(0.0, &state, &()).unwrap();
                let found = $name::default().acceleration(0.0, &state, &()).swing;
                let expected = $expected;
                assert!(
                    (found - expected).abs() < 1e-12,
                    "{}: {found}, {expected}",
                    stringify!($name)
                );
            };
        }
        check!(Hinges HingesState, -falls);
        check!(Askew AskewState, -falls);
        check!(Welded WeldedState, -falls);
        check!(BallAndWeld BallAndWeldState, -falls);
        check!(Pins PinsState, falls);
    }
}

/// A pendulum on another one. What joins them is a frame without mass, whose motion the lower one
/// would undo, if it were not held to the upper one; or nothing.
macro_rules! double {
    ($name:ident [$($frame:ident),*] $($joint:ident = $kind:expr),+) => {
        rigid_system!($name {
            bodies: [
                upper { mass: 1[kg], inertia: sphere(0.1), points: [o = (1, 0, 0), _h = (0, 0.2, 0.1)] },
                $($frame { mass: 0[kg], points: [_h = (0, 0.2, 0.1)] },)*
                lower { mass: 2[kg], inertia: sphere(0.3), points: [o = (0, 0, 0.7)] },
            ],
            joints: [swing = revolute(world(0, 0, 0), upper.o, world(0, 1, 0)), $($joint = $kind),+],
            fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
        });
    };
}
double!(Direct [] hung = spherical(upper.G, lower.o));
double!(HingeAndWeld [frame]
    first = revolute(upper.G, frame.G, body(0, 0, 1)),
    hung = spherical(frame.G, lower.o),
    second = weld(upper._h, frame._h)
);
double!(FramedBall [frame]
    first = spherical(upper.G, frame.G),
    hung = spherical(frame.G, lower.o),
    second = weld(upper._h, frame._h)
);
// in most other states, but not where it is closed, the rows of the points alone would hold the frame
double!(Corner [frame]
    first = planar(upper.G, frame.G, body(1, 0, 0)),
    hung = spherical(frame.G, lower.o),
    second = planar(upper._h, frame._h, body(0, 1, 0)),
    third = planar(upper._h, frame._h, body(0, 0, 1))
);
double!(TwoFrames [frame, beyond]
    first = spherical(upper.G, frame.G),
    next = spherical(frame.G, beyond.G),
    hung = spherical(beyond.G, lower.o),
    second = weld(upper._h, frame._h),
    third = weld(upper._h, beyond._h)
);

/// The same in the plane.
macro_rules! planar {
    ($name:ident [$($frame:ident)?] $($joint:ident = $kind:expr),+) => {
        rigid_system!($name {
            motion: planar,
            bodies: [
                upper { mass: 1[kg], inertia: disc(0.1), points: [o = (1, 0), _h = (0.2, 0.1)] },
                $($frame { mass: 0[kg], points: [_h = (0.2, 0.1)] },)?
                lower { mass: 2[kg], inertia: disc(0.3), points: [o = (0.7, 0)] },
            ],
            joints: [swing = revolute(world(0, 0), upper.o), $($joint = $kind),+],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
        });
    };
}
planar!(Flat [] hung = revolute(upper.G, lower.o));
planar!(FlatPins [frame]
    first = revolute(upper.G, frame.G),
    hung = revolute(frame.G, lower.o),
    second = revolute(upper._h, frame._h)
);
planar!(FlatWeld [frame]
    first = revolute(upper.G, frame.G),
    hung = revolute(frame.G, lower.o),
    second = weld(upper._h, frame._h)
);

#[test]
fn a_frame_that_is_held_twice_is_part_of_what_holds_it() {
    for (angle, angular_velocity) in [(0.0, 0.0), (0.4, 0.3), (-1.1, 10.0)] {
        let swing = Hinge {
            angle,
            angular_velocity,
        };
        macro_rules! compare {
            ($($name:ident $state:ident),+; $direct:ident $alone:ident; $hung:expr; $values:expr) => {
                let state = $alone { swing, hung: $hung };
                let expected = $direct::default().acceleration(0.0, &state, &());
                $(
                    let state = $state { swing, hung: $hung, ..$state::default() };
                    $name::default().check(0.0, &state, &()).unwrap();
                    let found = $name::default().acceleration(0.0, &state, &());
                    let parts = [(found.swing, expected.swing)].into_iter();
                    let hung = $values(found.hung).into_iter().zip($values(expected.hung));
                    for (found, expected) in parts.chain(hung) {
                        let size = 1.0 + angular_velocity.powi(2);
                        assert!(
                            (found - expected).abs() < 1e-11 * size,
                            "{}: {found}, {expected}",
                            stringify!($name)
                        );
                    }
                )+
            };
        }
        compare!(
            HingeAndWeld HingeAndWeldState, FramedBall FramedBallState, Corner CornerState,
            TwoFrames TwoFramesState; Direct DirectState;
            Rotation {
                attitude: UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.7),
                angular_velocity: [0.3, -0.2, 0.9].into(),
            };
            |hung: Vector3<f64>| [hung.x, hung.y, hung.z]
        );
        compare!(
            FlatPins FlatPinsState, FlatWeld FlatWeldState; Flat FlatState;
            Hinge { angle: 0.7, angular_velocity: -1.1 };
            |hung: f64| [hung]
        );
    }
}

/// Two bodies that two joints make one, in flight.
macro_rules! flying {
    ($name:ident $($joint:ident = $kind:expr),+) => {
        rigid_system!($name {
            bodies: [
                base {
                    mass: 2[kg],
                    inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
                    points: [h = (0.3, 0.1, 0), _k = (0.3, 0.1, 0.4), _l = (0.3, 0.4, 0)]
                },
                arm {
                    mass: 1[kg],
                    inertia: principal(0.1, 0.15, 0.2)[kg * m ^ 2],
                    points: [h = (-0.4, 0, 0.1), _k = (-0.4, 0, 0.5), _l = (-0.4, 0.3, 0.1)]
                },
            ],
            joints: [flight = free(base), $($joint = $kind),+],
        });
    };
}
flying!(Rigid first = weld(base.h, arm.h));
flying!(Offset
    first = revolute(base.h, arm.h, body(0, 0, 1)),
    second = revolute(base._l, arm._l, body(0, 0, 1))
);
flying!(OneHinge first = revolute(base.h, arm.h, body(0, 0, 1)));
flying!(TwoHinges
    first = revolute(base.h, arm.h, body(0, 0, 1)),
    second = revolute(base._k, arm._k, body(0, 0, 1))
);

// slopes of the directions of the axes are zero, or as small as rounding makes them
#[test]
fn two_bodies_fly_as_one_in_all_attitudes() {
    for number in 0..200 {
        let angle = 0.1 * f64::from(number);
        let axis = Vector3::new(angle.sin(), angle.cos(), (2.0 * angle).sin());
        let flight = Spatial {
            attitude: UnitQuaternion::from_scaled_axis(axis * angle),
            angular_velocity: axis * 0.7,
            ..Spatial::default()
        };
        let state = OffsetState {
            flight,
            ..OffsetState::default()
        };
        Offset::default().check(0.0, &state, &()).unwrap();
        let found = Offset::default().acceleration(0.0, &state, &()).flight;
        let expected = Rigid::default().acceleration(0.0, &RigidState { flight }, &());
        let error = (found.angular - expected.flight.angular).norm();
        assert!(error < 1e-12, "{number}: {found:?}, {expected:?}");
        // all slopes of a second hinge on the same axis are rounding
        let first = Hinge {
            angle,
            angular_velocity: 1.3,
        };
        let (one, two) = (OneHinge::default(), TwoHinges::default());
        let expected = one.acceleration(0.0, &OneHingeState { flight, first }, &());
        let found = two.acceleration(0.0, &TwoHingesState { flight, first }, &());
        let error = (found.first - expected.first).abs();
        assert!(error < 1e-12, "{number}: {found:?}, {expected:?}");
    }
}

// a rail that a second one repeats: where all positions are zero, so are all terms of the rows
rigid_system!(Rails {
    bodies: [
        sledge {
            mass: 1[kg],
            inertia: sphere(0.1),
            points: [p = (0, 1, 0)]
        },
        other {
            mass: 1[kg],
            inertia: sphere(0.1)
        },
    ],
    joints: [
        first = planar(world(0, 0, 0), sledge.G, world(0, 0, 1)),
        second = prismatic(world(0, 1, 0), other.G, world(1, 0, 0)),
        held = weld(sledge.p, other.G),
        again = prismatic(world(0, 1, 0), sledge.p, world(1, 0, 0)),
    ],
    fields: [push = mass * world(1.5[m / s ^ 2], 0, 0)],
});

#[test]
fn a_sledge_on_rails_starts_at_the_origin() {
    let found = Rails::default().acceleration(0.0, &RailsState::default(), &());
    assert!((found.second - 1.5).abs() < 1e-12, "{found:?}");
}

// a parallelogram in space: the directions of its axes need no acceleration, which rounding hides
rigid_system!(Parallelogram {
    bodies: [
        base {
            mass: 5[kg],
            inertia: sphere(1),
            points: [o = (0, 0, 0), p = (1, 0, 0)]
        },
        left {
            mass: 1[kg],
            inertia: sphere(0.1),
            points: [o = (-0.5, 0, 0), e = (0.5, 0, 0)]
        },
        right {
            mass: 1[kg],
            inertia: sphere(0.1),
            points: [o = (-0.5, 0, 0), e = (0.5, 0, 0)]
        },
        bar {
            mass: 1[kg],
            inertia: sphere(0.1),
            points: [p = (1, 0, 0)]
        },
    ],
    joints: [
        flight = free(base),
        a = revolute(base.o, left.o, body(0, 0, 1)),
        b = revolute(left.e, bar.G, body(0, 0, 1)),
        c = revolute(bar.p, right.e, body(0, 0, 1)),
        d = revolute(base.p, right.o, body(0, 0, 1)),
    ],
});

#[test]
fn a_parallelogram_moves_on_a_base_at_rest() {
    for number in 1..100 {
        let angle = 0.03 * f64::from(number);
        let axis = Vector3::new(angle.sin(), angle.cos(), 0.5);
        let hinge = |sign: f64| Hinge {
            angle: sign * angle,
            angular_velocity: sign * 0.7,
        };
        let mut state = ParallelogramState {
            flight: Spatial {
                attitude: UnitQuaternion::from_scaled_axis(axis * angle),
                ..Spatial::default()
            },
            a: hinge(1.0),
            b: hinge(-1.0),
            c: hinge(1.0),
        };
        let body = Parallelogram::default();
        body.project(0.0, &mut state, &()).unwrap();
        let found = body.acceleration(0.0, &state, &());
        assert!((found.a - found.c).abs() < 1e-12, "{number}: {found:?}");
    }
}
