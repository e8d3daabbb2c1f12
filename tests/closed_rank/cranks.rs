//! A coupler on three parallel cranks, in the plane.

use std::f64::consts::FRAC_PI_2;

use newton_euler::integrate::IntegrationError;
use newton_euler::prelude::*;

macro_rules! cranks {
    ($name:ident, $state:ident, $long:literal) => {
        rigid_system!($name {
            motion: planar,
            params: [long = $long[m]],
            bodies: [
                first {
                    mass: 1[kg],
                    inertia: 0.1[kg * m ^ 2],
                    points: [o = (0, -0.5), a = (0, 0.5)]
                },
                coupler {
                    mass: 2[kg],
                    inertia: 0.8[kg * m ^ 2],
                    points: [a = (-1, 0), b = (0, 0), c = (1, 0)]
                },
                second {
                    mass: 1.5[kg],
                    inertia: 0.2[kg * m ^ 2],
                    points: [p = (0, -0.5), b = (0, 0.5)]
                },
                third {
                    mass: 0.7[kg],
                    inertia: 0.15[kg * m ^ 2],
                    points: [q = (0, -0.5 * long), c = (0, 0.5 * long)]
                },
            ],
            joints: [
                o = revolute(world(0, 0), first.o),
                a = revolute(first.a, coupler.a),
                b = revolute(coupler.b, second.b),
                c = revolute(coupler.c, third.c),
                p = revolute(world(1, 0), second.p),
                q = revolute(world(2, 0), third.q),
            ],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
        });

        impl $name {
            fn all_alike(angle: f64, rate: f64) -> $state {
                let hinge = |angle, angular_velocity| Hinge {
                    angle,
                    angular_velocity,
                };
                $state {
                    o: hinge(angle, rate),
                    a: hinge(-angle, -rate),
                    b: hinge(angle, rate),
                    c: hinge(angle, rate),
                }
            }
        }
    };
}
cranks!(Parallel, ParallelState, 1);
cranks!(Unequal, UnequalState, 1.2);

/// The moment of inertia of what turns as one crank does, and its moment of weight.
const INERTIA: f64 = 0.1 + 0.2 + 0.15 + 0.25 * (1.0 + 1.5 + 0.7) + 2.0;
const WEIGHT: f64 = 9.81 * (0.5 * (1.0 + 1.5 + 0.7) + 2.0);

#[test]
fn equations_are_whole() {
    for line in Parallel::EQUATIONS.lines() {
        let opened = line.matches('(').count();
        assert_eq!(opened, line.matches(')').count(), "{line}");
    }
    assert!(Parallel::EQUATIONS.contains("\nholds = "));
    assert!(Parallel::EQUATIONS.contains("_load = "));
}

#[test]
fn three_cranks_move_as_one() {
    let cranks = Parallel::default();
    for number in 0..=126 {
        let angle = 0.05 * f64::from(number);
        for rate in [0.0, 1.3] {
            let mut state = Parallel::all_alike(angle, rate);
            for is_projected in [false, true] {
                if is_projected {
                    if (angle.sin().abs() - 1.0).abs() < 0.01 {
                        continue;
                    }
                    state.a.angle += 1e-3;
                    state.c.angular_velocity -= 0.01 * rate;
                    cranks.project(0.0, &mut state, &()).unwrap();
                }
                let expected = WEIGHT / INERTIA * state.o.angle.sin();
                let found = cranks.acceleration(0.0, &state, &());
                let signed = [found.o, -found.a, found.b, found.c];
                for one in signed {
                    let error = (one - expected).abs();
                    assert!(
                        error < 1e-11,
                        "{angle} {rate} {is_projected}: {found:?} {expected}"
                    );
                }
            }
        }
    }
}

#[test]
fn energy_is_kept_over_turns() {
    let cranks = Parallel::default();
    let start = Parallel::all_alike(0.3, 4.0);
    let end = cranks.integrate(&start).to(3.0).unwrap();
    assert!(end.o.angle.abs() > 6.3, "{end:?}");
    let energy = |state: &ParallelState| {
        let Hinge {
            angle,
            angular_velocity,
        } = state.o;
        0.5 * INERTIA * angular_velocity.powi(2) + WEIGHT * angle.cos()
    };
    let [before, after] = [&start, &end].map(energy);
    assert!((after - before).abs() < 1e-8 * before, "{before} {after}");
}

// numbers for which all cranks are parallel, of a description in which they are not
#[test]
fn what_is_special_at_run_time_alone_gives_no_number() {
    let cranks = Unequal::new(UnequalParams { long: 1.0 }).unwrap();
    let is_none = |state: &UnequalState| {
        let found = cranks.acceleration(0.0, state, &());
        let all = [found.o, found.a, found.b, found.c];
        assert!(all.iter().all(|one| one.is_nan()), "{state:?}: {found:?}");
    };
    for number in 0..200 {
        let angle = 0.05 + 0.03 * f64::from(number);
        // all in a line is a change point
        if angle.cos().abs() < 0.05 {
            continue;
        }
        for rate in [0.0, 1.3] {
            let mut state = Unequal::all_alike(angle, rate);
            cranks.check(0.0, &state, &()).unwrap();
            is_none(&state);
            state.a.angle += 1e-3;
            state.c.angular_velocity -= 0.01 * rate;
            cranks.project(0.0, &mut state, &()).unwrap();
            is_none(&state);
            let error = cranks.integrate(&state).to(1.0).unwrap_err();
            assert!(
                matches!(
                    error,
                    IntegrationError::Undetermined {
                        constraint: "q_2",
                        ..
                    }
                ),
                "{error}"
            );
        }
    }
}

// a description in which all cranks are parallel, with numbers for which they are not
#[test]
fn what_is_not_special_at_run_time_is_an_error() {
    let cranks = Parallel::new(ParallelParams { long: 1.5 }).unwrap();
    for number in 0..60 {
        let angle = 0.1 * f64::from(number);
        let state = Parallel::all_alike(angle, 1.0);
        assert!(cranks.check(0.0, &state, &()).is_err(), "{angle}");
    }
    // the first crank ends where the second one stands, and the third one keeps both from turning
    let turned = 0.6875_f64.acos();
    let third = (1.0 - 2.0 * turned.cos()).atan2(2.0 * turned.sin());
    let mut state = Parallel::all_alike(0.0, 0.0);
    state.o.angle = -FRAC_PI_2;
    state.a.angle = turned + FRAC_PI_2;
    state.b.angle = -FRAC_PI_2;
    state.c.angle = third - turned;
    cranks.check(0.0, &state, &()).unwrap();
    let found = cranks.acceleration(0.0, &state, &());
    assert!(found.o.is_nan(), "{found:?}");
}
