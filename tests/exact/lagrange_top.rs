//! Lagrange's top in closed form: 25-digit references, conserved quantities, the group property,
//! near the vertical and near the separatrix.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use crate::reference::turning::{Turning, error, tops};
use crate::reference::{attitude, distance, number, numbers, trajectory, vector};
use newton_euler::exact::{FreeRotation, LagrangeTop, Path, Pendulum};
use newton_euler::nalgebra::{Quaternion, Unit, UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;

/// Half a unit in the last place of one.
const ROUNDING: f64 = f64::EPSILON / 2.0;

fn path(case: &Turning<2>) -> LagrangeTop {
    of_axes(case, case.moments, case.drive, &case.start)
}

/// A top with the axes of a case.
fn of_axes(case: &Turning<2>, moments: [f64; 2], couple: f64, start: &Rotation) -> LagrangeTop {
    let [axis, up] = case.axes;
    let couple = up * (couple / up.norm());
    LagrangeTop::new(moments, Unit::new_unchecked(axis), couple, start)
}

/// Under an upright couple.
fn under(moments: [f64; 2], couple: f64, start: &Rotation) -> LagrangeTop {
    LagrangeTop::new(moments, Vector3::z_axis(), Vector3::z() * couple, start)
}

/// The angle turned: the angular velocity at most, for the time.
fn angle(case: &Turning<2>) -> f64 {
    let path = path(case);
    let part = case.time / 256.0;
    let rates = (0..256).map(|k| path.at(part * f64::from(k)).angular_velocity.norm());
    rates.sum::<f64>() * part.abs()
}

/// In units of the bound: `2e-14` and four roundings for each radian, and no more than four times the effect of one ulp.
fn check(case: &Turning<2>) {
    let end = path(case).at(case.time);
    let error = error(&end, &case.end);
    let bound = 2e-14 + 4.0 * ROUNDING * angle(case);
    assert!(error <= bound, "{}: {error:e} > {bound:e}", case.name);
    let end_of = |moments, couple, start: &_| of_axes(case, moments, couple, start).at(case.time);
    let bound = 4.0 * case.effect_of_one_ulp(end_of);
    assert!(error <= bound, "{}: {error:e} > {bound:e}", case.name);
}

#[test]
fn end_states_of_all_kinds_of_motion() {
    let cases = tops();
    assert!(cases.len() > 130);
    for case in cases {
        check(&case);
        let turned = path(&case).at(case.time).attitude.coords;
        let turned = turned.dot(&case.end.attitude.coords);
        assert!(turned > 0.0, "{}: the sign of q jumps", case.name);
    }
}

#[test]
fn end_states_of_published_problems() {
    for name in ["lagrange_nutation", "sleeping_top"] {
        let problem = trajectory(name);
        let [across, _, along] = numbers(&problem["I"]);
        check(&Turning {
            name: name.to_owned(),
            moments: [across, along],
            drive: number(&problem["k"]),
            axes: [Vector3::z(); 2],
            start: Rotation {
                attitude: attitude(&problem["q0"]),
                angular_velocity: vector(&problem["w0"]),
            },
            time: number(&problem["T"]),
            end: Rotation {
                attitude: attitude(&problem["q_ref"]),
                angular_velocity: vector(&problem["w_ref"]),
            },
        });
    }
}

fn turning(rates: [f64; 3]) -> Rotation {
    Rotation {
        attitude: UnitQuaternion::new_normalize(Quaternion::new(0.5, 0.5, -0.1, 0.7)),
        angular_velocity: rates.into(),
    }
}

/// Of moments one across and 1/2 along the third axis, and a couple of one upwards.
fn top(start: &Rotation) -> LagrangeTop {
    under([1.0, 0.5], 1.0, start)
}

/// Energy and vertical angular momentum of such a one.
fn conserved(state: &Rotation) -> [f64; 2] {
    let vertical = state.attitude.inverse() * Vector3::z();
    let [x, y, z] = state.angular_velocity.into();
    let momentum = Vector3::new(x, y, 0.5 * z);
    let kinetic = 0.5 * momentum.dot(&state.angular_velocity);
    [kinetic + vertical.z, momentum.dot(&vertical)]
}

/// The larger of the errors of attitude and angular velocity, the latter in units of the couple's
/// rate, 1 rad/s, and of its own size: almost at rest, it is only rounding.
fn difference(state: &Rotation, expected: &Rotation) -> f64 {
    let rates = (state.angular_velocity - expected.angular_velocity).amax();
    let size = 1.0 + expected.angular_velocity.norm();
    f64::max(distance(&state.attitude, &expected.attitude), rates / size)
}

/// Anywhere, and as often next to the vertical as far from it.
fn attitudes() -> impl Strategy<Value = UnitQuaternion<f64>> {
    let part = || -1.0..1.0_f64;
    (
        part(),
        part(),
        part(),
        part(),
        -12.0..0.0_f64,
        any::<[bool; 2]>(),
    )
        .prop_map(|(a, b, c, d, size, [is_near, is_upright])| {
            let small = if is_near { 10.0_f64.powf(size) } else { 1.0 };
            let [near, far] = if is_upright {
                [1.0, small]
            } else {
                [small, 1.0]
            };
            let parts = [a * near, b * far, c * far, d * near];
            let [w, x, y, z] = parts.map(|part| part + 1e-20);
            UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z))
        })
}

fn starts() -> impl Strategy<Value = Rotation> {
    let rate = || -3.0..3.0_f64;
    let size = prop_oneof![
        Just(0.0),
        Just(1.0),
        (-12.0..0.0_f64).prop_map(|size| 10.0_f64.powf(size))
    ];
    (attitudes(), rate(), rate(), -8.0..8.0_f64, size).prop_map(|(attitude, x, y, z, size)| {
        Rotation {
            attitude,
            angular_velocity: Vector3::new(size * x, size * y, z),
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn energy_and_vertical_angular_momentum_are_kept(start in starts(), time in -40.0..40.0) {
        let end = top(&start).at(time);
        let ([energy, momentum], [energy_after, momentum_after]) = (conserved(&start), conserved(&end));
        let size = 1.0 + start.angular_velocity.norm_squared();
        prop_assert!((energy_after - energy).abs() < 8e-15 * size);
        prop_assert!((momentum_after - momentum).abs() < 8e-15 * size);
        prop_assert_eq!(end.angular_velocity.z, start.angular_velocity.z);
    }

    /// Rates of change by differences: Euler's equations and the kinematics hold.
    #[test]
    fn equations_of_motion(start in starts(), time in -20.0..20.0) {
        let path = top(&start);
        let h = 1e-3;
        let [before, now, after] = [-h, 0.0, h].map(|step| path.at(time + step));
        let (w, vertical) = (now.angular_velocity, now.attitude.inverse() * Vector3::z());
        let expected = Vector3::new(0.5 * w.y * w.z + vertical.y, -0.5 * w.x * w.z - vertical.x, 0.0);
        let rate = (after.angular_velocity - before.angular_velocity) / (2.0 * h);
        let size = 1.0 + w.norm().powi(4);
        prop_assert!((rate - expected).norm() < h * h * size, "{} {}", rate, expected);
        let expected = now.attitude.quaternion() * Quaternion::from_imag(0.5 * w);
        let rate = (after.attitude.coords - before.attitude.coords) / (2.0 * h);
        prop_assert!((rate - expected.coords).norm() < h * h * size);
    }

    #[test]
    fn two_motions_are_one(start in starts(), first in -3.0..3.0, second in -3.0..3.0) {
        let halting = top(&top(&start).at(first)).at(second);
        prop_assert!(difference(&halting, &top(&start).at(first + second)) < 1e-10);
        let still = top(&start).at(0.0);
        prop_assert!((still.attitude.coords - start.attitude.coords).amax() < 4e-15);
        prop_assert!((still.angular_velocity - start.angular_velocity).amax() < 4e-15 * (1.0 + start.angular_velocity.norm()));
    }

    /// The axis may lie anywhere in the body, the couple point anywhere.
    #[test]
    fn any_axes(start in starts(), body in attitudes(), world in attitudes(), time in -5.0..5.0) {
        let moved = Rotation {
            attitude: world * start.attitude * body.inverse(),
            angular_velocity: body * start.angular_velocity,
        };
        let plain = top(&start).at(time);
        let end = LagrangeTop::new([1.0, 0.5], body * Vector3::z_axis(), world * Vector3::z(), &moved).at(time);
        let expected = Rotation {
            attitude: world * plain.attitude * body.inverse(),
            angular_velocity: body * plain.angular_velocity,
        };
        prop_assert!(difference(&end, &expected) < 1e-11);
    }

    #[test]
    fn any_scale(start in starts(), exponent in -100..100, time in -5.0..5.0) {
        let factor = 2.0_f64.powi(exponent);
        let faster = Rotation { angular_velocity: start.angular_velocity * factor, ..start };
        let moments = [1e-7, 0.5e-7];
        let size = 1e-7 * factor * factor;
        let end = LagrangeTop::new(moments, Vector3::z_axis(), Vector3::z() * size, &faster).at(time / factor);
        let expected = top(&start).at(time);
        prop_assert!(distance(&end.attitude, &expected.attitude) < 1e-10);
        prop_assert!((end.angular_velocity / factor - expected.angular_velocity).amax() < 1e-10);
    }
}

/// Without a couple it is the free body; upright and at rest it stays so, at any spin.
#[test]
fn what_does_not_nod() {
    let start = turning([0.4, 0.1, 3.0]);
    let free = LagrangeTop::new([2.0, 1.0], Vector3::z_axis(), Vector3::zeros(), &start);
    let expected = FreeRotation::symmetric([2.0, 1.0], Vector3::z_axis(), &start);
    assert_eq!(free.at(7.0), expected.at(7.0));
    assert_eq!(free.period(), None);
    for (attitude, spin) in [
        (UnitQuaternion::identity(), 0.3),
        (UnitQuaternion::identity(), 4.0),
        (
            UnitQuaternion::new_unchecked(Quaternion::new(0.0, 1.0, 0.0, 0.0)),
            -2.0,
        ),
        (UnitQuaternion::identity(), 0.0),
    ] {
        let start = Rotation {
            attitude,
            angular_velocity: Vector3::z() * spin,
        };
        let end = top(&start).at(1e6);
        assert_eq!(end.angular_velocity, start.angular_velocity);
        let [upright, hanging] = [
            end.attitude.w.hypot(end.attitude.k),
            end.attitude.i.hypot(end.attitude.j),
        ];
        assert_eq!(upright == 0.0, attitude.w == 0.0);
        assert_eq!(hanging == 0.0, attitude.i == 0.0);
    }
}

/// Steady precession: `A Ω² cos θ - C ω₃ Ω + k = 0`, here with exact numbers.
#[test]
fn steady_precession() {
    // level: Ω = k/(C ω₃) = 1/4 about the vertical
    let level = Rotation {
        attitude: UnitQuaternion::new_normalize(Quaternion::new(1.0, 1.0, 0.0, 0.0)),
        angular_velocity: Vector3::new(0.0, 0.25, 8.0),
    };
    let end = top(&level).at(40.0);
    let axis = end.attitude * Vector3::z();
    let expected = Vector3::new(f64::sin(10.0), -f64::cos(10.0), 0.0);
    assert!((axis - expected).norm() < 1e-14, "{axis} {expected}");
    assert!((end.angular_velocity.xy().norm() - 0.25).abs() < 1e-15);
}

/// `w·Γ = p (1 - u)`, `w² = 2 a (1 - u)`, with exact numbers: the axis rises to the vertical, and stays there.
#[test]
fn the_separatrix() {
    for spin in [2.0, -2.0, 0.0] {
        let along = 0.5 * spin;
        let start = Rotation {
            attitude: UnitQuaternion::new_normalize(Quaternion::new(1.0, 1.0, 0.0, 0.0)),
            angular_velocity: Vector3::new(-f64::sqrt(2.0 - along * along), along, spin),
        };
        let path = top(&start);
        if spin != 0.0 {
            assert_eq!(path.period(), None);
            for time in [-1e4, 1e4] {
                let end = path.at(time);
                assert_eq!(
                    (end.attitude.i, end.attitude.j),
                    (0.0, 0.0),
                    "{spin} {time}"
                );
                assert_eq!(end.angular_velocity.xy().norm(), 0.0);
            }
        }
        // 1 - u = (1 - u₁) sech²: u = 1 - (2 - p²/2a) sech² (λ t + u₀)
        let depth = 2.0 - 0.5 * along * along;
        let rate = f64::sqrt(0.5 * depth);
        let first = f64::acosh(f64::sqrt(depth));
        for time in [-1.0, 0.0, 0.7, 3.0_f64] {
            let expected = 1.0 - depth / (rate * time + first).cosh().powi(2);
            let height = (path.at(time).attitude * Vector3::z()).z;
            assert!(
                (height - expected).abs() < 4e-15,
                "{spin} {time}: {height} {expected}"
            );
        }
    }
}

/// A plane pendulum, swinging and going round.
#[test]
fn in_a_plane_it_is_a_pendulum() {
    for (angle, speed) in [(1.0, 0.0), (0.3, 1.5), (0.0, 2.5), (3.0, -0.4)] {
        let hanging = Hinge {
            angle,
            angular_velocity: speed,
        };
        let turned = |angle: f64| {
            let half = 0.5 * (angle + core::f64::consts::PI);
            UnitQuaternion::new_unchecked(Quaternion::new(half.cos(), half.sin(), 0.0, 0.0))
        };
        let start = Rotation {
            attitude: turned(angle),
            angular_velocity: Vector3::x() * speed,
        };
        let pendulum = Pendulum::new(1.0, 0.0, &hanging);
        for time in [-4.0, 0.5, 9.0] {
            let (end, expected) = (top(&start).at(time), pendulum.at(time));
            assert!((end.attitude.coords - turned(expected.angle).coords).amax() < 2e-14);
            assert!((end.angular_velocity.x - expected.angular_velocity).abs() < 2e-14);
        }
    }
}

/// At rest with any tilt: it falls the way it leans, in the plane of the tilt, as a pendulum does that is told from upright, the same
/// forwards and backwards; and from there it goes back.
#[test]
fn released_next_to_upright() {
    for exponent in [-1, -3, -7, -8, -9, -12, -14, -15, -16, -25] {
        for heading in [0.0, 0.7, 2.0, -2.6, -1.0] {
            let tilt = 10.0_f64.powi(exponent);
            let [sine, cosine] = [f64::sin(0.5 * tilt), f64::cos(0.5 * tilt)];
            let direction = Vector3::new(f64::cos(heading), f64::sin(heading), 0.0);
            let tilted = |sine, cosine| Quaternion::from_parts(cosine, direction * sine);
            let start = Rotation {
                attitude: UnitQuaternion::new_unchecked(tilted(sine, cosine)),
                angular_velocity: Vector3::zeros(),
            };
            let leaning = Hinge {
                angle: tilt,
                angular_velocity: 0.0,
            };
            let pendulum = Pendulum::new(1.0, core::f64::consts::PI, &leaning);
            for part in [0.3, 1.0, 1.5, 2.5] {
                let time = 1.0 - part * tilt.ln();
                let (end, expected) = (top(&start).at(time), pendulum.at(time));
                let half = 0.5 * expected.angle;
                let attitude = tilted(half.sin(), half.cos());
                let rates = direction * expected.angular_velocity;
                let bound =
                    2e-14 * f64::min(1.0, expected.angle.abs() + expected.angular_velocity.abs());
                let leans = (end.attitude.imag() - attitude.imag()).amax();
                assert!(leans < bound, "{tilt:e} {heading} {time}: {leans:e}");
                assert!((end.attitude.w - attitude.w).abs() < 2e-14);
                assert!((end.angular_velocity - rates).amax() < bound);
                let before = top(&start).at(-time);
                assert!((before.attitude.coords - end.attitude.coords).amax() < bound);
                assert!((before.angular_velocity + end.angular_velocity).amax() < bound);
            }
            // what is rounded at the turn grows on the way back
            let back = top(&top(&start).at(4.0)).at(-4.0);
            let apart = (back.attitude.imag() - start.attitude.imag()).amax();
            assert!(apart < 4e-15 * f64::cosh(8.0) * tilt, "{tilt:e}: {apart:e}");
        }
    }
}

/// A hundred thousand seconds: phases lose no more than the rounding of their rates.
#[test]
fn long_times() {
    let start = turning([0.4, 0.1, 6.0]);
    let path = top(&start);
    let [energy, momentum] = conserved(&start);
    let end = path.at(1e5);
    let [energy_after, momentum_after] = conserved(&end);
    assert!((energy - energy_after).abs() < 1e-13 && (momentum - momentum_after).abs() < 1e-13);
    let nod = path.period().unwrap();
    let height = |state: &Rotation| (state.attitude * Vector3::z()).z;
    let angle = 1e5 * start.angular_velocity.norm();
    assert!((height(&path.at(4e4 * nod)) - height(&start)).abs() < f64::EPSILON * angle);
}

/// Numbers that are no motion give no motion, and return.
#[test]
fn not_a_number() {
    for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
        for place in 0..3 {
            let mut rates = [1.0, -2.0, 0.5];
            rates[place] = bad;
            assert!(
                !top(&turning(rates))
                    .at(1.0)
                    .angular_velocity
                    .norm()
                    .is_finite()
            );
        }
        assert!(top(&turning([1.0, -2.0, 0.5])).at(bad).attitude.w.is_nan());
    }
}
