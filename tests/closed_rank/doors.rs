//! Doors on two hinges along one axis, which is tilted in steps: that the second hinge follows from
//! the first depends on sines of sums of angles.

use newton_euler::prelude::*;

/// A door on one hinge, and the same on two.
macro_rules! door {
    ($name:ident $($first:expr),+; $whole:expr) => {
        rigid_system!($name {
            bodies: [door {
                mass: 1.3[kg],
                inertia: principal(0.1, 0.2, 0.17)[kg * m ^ 2],
                points: [o = (0.3, 0, 0), p = (0.3, 0.5 * $whole.sin(), 0.5 * $whole.cos())],
            }],
            joints: [
                low = revolute(world(0, 0, 0), door.o, world(0, 0, 1))
                    $(.turned(body(1, 0, 0), $first))+,
                high = revolute(world(0, 0, 0.5), door.p, world(0, 0, 1)).turned(body(1, 0, 0), $whole),
            ],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2], 0)],
        });
    };
}
door!(Whole 30[deg]; 30[deg]);
door!(TenAndTwenty 10[deg], 20[deg]; 30[deg]);
door!(Odd 20.3[deg], 35.4[deg]; 55.7[deg]);
door!(Eighths 22.5[deg], 22.5[deg]; 45[deg]);

/// A door on a frame that is tilted first, and the door on it.
macro_rules! framed {
    ($name:ident $first:expr, $second:expr; $whole:expr) => {
        rigid_system!($name {
            bodies: [
                frame {
                    mass: 1[kg],
                    inertia: principal(1, 1, 1)[kg * m ^ 2]
                },
                door {
                    mass: 1.3[kg],
                    inertia: principal(0.1, 0.2, 0.17)[kg * m ^ 2],
                    points: [
                        o = (0.3, 0, 0),
                        p = (0.3, 0.5 * $whole.sin(), 0.5 * $whole.cos())
                    ],
                },
            ],
            joints: [
                tilted = weld(world(0, 0, 0), frame.G).turned(body(1, 0, 0), $first),
                low = revolute(frame.G, door.o, frame.body(0, $first.sin(), $first.cos()))
                    .turned(body(1, 0, 0), $second),
                high = revolute(world(0, 0, 0.5), door.p, world(0, 0, 1))
                    .turned(body(1, 0, 0), $whole),
            ],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2], 0)],
        });
    };
}
framed!(Framed 10[deg], 35[deg]; 45[deg]);
framed!(Degrees 7[deg], 8[deg]; 15[deg]);
framed!(Decimals 20.3[deg], 35.4[deg]; 55.7[deg]);
framed!(Back 41.00007[deg], -12.3[deg]; 28.70007[deg]);
framed!(Heptagon (2 * PI / 7), (-PI / 5); (3 * PI / 35));

/// The acceleration of a door about the vertical axis through its hinges, tilted by an angle.
fn expected(tilt: f64, angle: f64) -> f64 {
    let (sine, cosine) = f64::to_radians(tilt).sin_cos();
    // the axis in the axes of the door, and its inertia about it: G is 0.3 m off the axis
    let inertia = 0.2 * sine * sine + 0.17 * cosine * cosine + 1.3 * 0.3 * 0.3;
    1.3 * 9.81 * 0.3 * angle.cos() / inertia
}

#[test]
fn doors_swing() {
    for step in 0..5 {
        let low = Hinge {
            angle: 0.4 * f64::from(step) - 0.7,
            angular_velocity: 0.3,
        };
        macro_rules! check {
            ($name:ident $state:ident $tilt:expr) => {
                let (door, state) = ($name::default(), $state { low });
                door.check(0.0, &state, &()).unwrap();
                let found = door.acceleration(0.0, &state, &()).low;
                let expected = expected($tilt, low.angle);
                assert!(
                    (found - expected).abs() < 1e-12,
                    "{}: {found}, {expected}",
                    stringify!($name)
                );
            };
        }
        check!(Whole WholeState 30.0);
        check!(TenAndTwenty TenAndTwentyState 30.0);
        check!(Odd OddState 55.7);
        check!(Eighths EighthsState 45.0);
        check!(Framed FramedState 45.0);
        check!(Degrees DegreesState 15.0);
        check!(Decimals DecimalsState 55.7);
        check!(Back BackState 28.70007);
        check!(Heptagon HeptagonState 540.0 / 35.0);
    }
}
