//! The method CF4 has order four in every coordinate, compared with closed forms and 40-digit
//! trajectories.
#![allow(clippy::cast_precision_loss, reason = "numbers of steps")]

use std::ops::Range;

use nalgebra::{UnitQuaternion, Vector2, Vector3};
use newton_euler::integrate::{cf4, cf4_step};
use newton_euler::prelude::*;

use crate::reference::{attitude, distance, number, statement, trajectory, vector};

/// A body turning about G or a fixed point, in principal axes, under the torque k Γ × c, with Γ the vertical.
struct Turning {
    moments: Vector3<f64>,
    torque: f64,
    arm: Vector3<f64>,
}

impl Turning {
    fn free(moments: [f64; 3]) -> Self {
        let [moments, arm] = [moments.into(), Vector3::zeros()];
        Self {
            moments,
            torque: 0.0,
            arm,
        }
    }

    /// From the reference, with its state at the start.
    fn read(name: &str) -> (Self, Rotation) {
        let problem = trajectory(name);
        let body = Self {
            moments: vector(&problem["I"]),
            torque: number(&problem["k"]),
            arm: vector(&problem["c"]),
        };
        let start = Rotation {
            attitude: attitude(&problem["at_T_10"]["q0_as_doubles"]),
            angular_velocity: vector(&problem["w0"]),
        };
        (body, start)
    }

    fn energy(&self, state: &Rotation) -> f64 {
        let vertical = state.attitude.inverse() * Vector3::z();
        let w = state.angular_velocity;
        0.5 * w.dot(&self.moments.component_mul(&w)) + self.torque * vertical.dot(&self.arm)
    }

    fn angular_momentum(&self, state: &Rotation) -> Vector3<f64> {
        state.attitude * self.moments.component_mul(&state.angular_velocity)
    }
}

impl RigidBody for Turning {
    type Scalar = f64;
    type State = Rotation;
    type Input = ();

    fn acceleration(&self, _: f64, state: &Rotation, (): &()) -> Vector3<f64> {
        let vertical = state.attitude.inverse() * Vector3::z();
        let w = state.angular_velocity;
        let moment = vertical.cross(&self.arm) * self.torque;
        (moment - w.cross(&self.moments.component_mul(&w))).component_div(&self.moments)
    }
}

/// The slope of log error against log step, by least squares.
fn order(errors: &[(usize, f64)]) -> f64 {
    let points: Vec<(f64, f64)> = errors
        .iter()
        .map(|&(n, e)| (-(n as f64).ln(), e.ln()))
        .collect();
    let count = points.len() as f64;
    let (x, y) = points
        .iter()
        .fold((0.0, 0.0), |(x, y), p| (x + p.0 / count, y + p.1 / count));
    let slopes = points
        .iter()
        .map(|p| ((p.0 - x) * (p.1 - y), (p.0 - x).powi(2)));
    let (above, below) = slopes.fold((0.0, 0.0), |sum, s| (sum.0 + s.0, sum.1 + s.1));
    above / below
}

/// Orders in the coordinates that `error` tells apart, over four halvings of the step.
fn orders<const N: usize>(steps: usize, error: impl Fn(usize) -> [f64; N]) -> [f64; N] {
    let runs: Vec<(usize, [f64; N])> = (0..4).map(|k| (steps << k, error(steps << k))).collect();
    std::array::from_fn(|i| order(&runs.iter().map(|(n, e)| (*n, e[i])).collect::<Vec<_>>()))
}

fn assert_fourth(orders: &[f64]) {
    assert!(
        orders.iter().all(|order| (3.7..4.3).contains(order)),
        "{orders:?}"
    );
}

fn end<B: RigidBody<Scalar = f64, Input = ()>>(
    body: &B,
    start: &B::State,
    times: Range<f64>,
    steps: usize,
) -> B::State {
    cf4(body, start, &(), times, steps)
}

/// Asymmetric free body, heavy symmetric top with nutation: attitude and rates at 10 s.
#[test]
fn order_four_in_attitude_and_rates() {
    // The coarsest steps turn the bodies by about 0.06 and 0.05 rad: there the leading term rules.
    for (name, steps) in [("asymmetric_free", 500), ("lagrange_nutation", 2000)] {
        let (body, start) = Turning::read(name);
        let expected = &trajectory(name)["at_T_10"];
        let [q, w] = ["q_ref", "w_ref"].map(|name| &expected[name]);
        let (q, w) = (attitude(q), vector(w));
        let errors = |steps| {
            let end = end(&body, &start, 0.0..10.0, steps);
            [
                distance(&end.attitude, &q),
                (end.angular_velocity - w).amax(),
            ]
        };
        assert_fourth(&orders(steps, errors));
        // Sixteen times finer than a start with errors below 1e-3.
        let [attitude, rates] = errors(16 * steps);
        assert!(
            attitude < 2e-8 && rates < 2e-8,
            "{name}: {attitude:e}, {rates:e}"
        );
    }
}

/// F11: the closed form of a body that flips.
#[test]
fn torque_free_closed_form() {
    let body = Turning::free([1.0, 2.0, 3.0]);
    let start = Rotation {
        angular_velocity: Vector3::new(0.01, 1.0, 0.01),
        ..Rotation::default()
    };
    let expected = statement("F11 torque-free (Dzhanibekov), J=(1,2,3), w0=(.01,1,.01)");
    let later = end(&body, &start, 0.0..10.0, 5000);
    // Steps of 2 mrad: (2e-3)⁴ times 10 rad times what the instability amplifies, exp(10/√3) = 320.
    assert!((later.angular_velocity - vector(&expected["w(10) closed form"])).amax() < 1e-11);
    assert!(
        distance(
            &later.attitude,
            &attitude(&expected["q(10) (scalar first, body->world)"])
        ) < 1e-11
    );
    let expected = statement("F11 torque-free (Dzhanibekov), t=100");
    let later = end(&body, &start, 0.0..100.0, 50_000);
    assert!((later.angular_velocity - vector(&expected["w"])).amax() < 1e-9);
    assert!(distance(&later.attitude, &attitude(&expected["q"])) < 1e-9);
}

/// What the method must not be: the same stages with a single exponential at the end.
#[test]
fn one_exponential_is_order_two() {
    let (body, start) = Turning::read("asymmetric_free");
    let expected = attitude(&trajectory("asymmetric_free")["at_T_10"]["q_ref"]);
    let single = |steps: usize| {
        let h = 10.0 / steps as f64;
        let rate = |state: &Rotation| state.rate(&body.acceleration(0.0, state, &()));
        let step = |y: Rotation, _| {
            let k1 = rate(&y);
            let k2 = rate(&y.moved(&(k1 * (h / 2.0))));
            let k3 = rate(&y.moved(&(k2 * (h / 2.0))));
            let k4 = rate(&y.moved(&(k3 * h)));
            y.moved(&((k1 + (k2 + k3) * 2.0 + k4) * (h / 6.0)))
        };
        [distance(&(0..steps).fold(start, step).attitude, &expected)]
    };
    let [order] = orders(500, single);
    assert!((1.7..2.3).contains(&order), "{order}");
}

/// A free symmetric top pushed along a prescribed path by a force given in body axes, so that errors of the attitude
/// reach the path. Rotation in closed form (F12), path (cos t, sin 2t, t³/6).
struct Pushed {
    turning: Turning,
    precession: f64,
    tilt: f64,
    spin: f64,
}

impl Pushed {
    fn new() -> Self {
        let [i1, i3, momentum, tilt]: [f64; 4] = [1.0, 1.5, 3.0, 0.5];
        Self {
            turning: Turning::free([i1, i1, i3]),
            precession: momentum / i1,
            tilt,
            spin: momentum * tilt.cos() * (1.0 / i3 - 1.0 / i1),
        }
    }

    fn exact(&self, t: f64) -> Spatial {
        let about = UnitQuaternion::from_axis_angle;
        let attitude = about(&Vector3::z_axis(), self.precession * t)
            * about(&Vector3::x_axis(), self.tilt)
            * about(&Vector3::z_axis(), self.spin * t);
        let momentum = Vector3::z() * self.precession * self.turning.moments.x;
        let in_body = attitude.inverse() * momentum;
        Spatial {
            position: Vector3::new(t.cos(), (2.0 * t).sin(), t.powi(3) / 6.0),
            attitude,
            velocity: Vector3::new(-t.sin(), 2.0 * (2.0 * t).cos(), t * t / 2.0),
            angular_velocity: in_body.component_div(&self.turning.moments),
        }
    }
}

impl RigidBody for Pushed {
    type Scalar = f64;
    type State = Spatial;
    type Input = ();

    fn acceleration(&self, t: f64, state: &Spatial, (): &()) -> SpatialAcceleration {
        let &Spatial {
            attitude,
            angular_velocity,
            ..
        } = state;
        let push =
            self.exact(t).attitude.inverse() * Vector3::new(-t.cos(), -4.0 * (2.0 * t).sin(), t);
        SpatialAcceleration {
            linear: attitude * push,
            angular: self.turning.acceleration(
                t,
                &Rotation {
                    attitude,
                    angular_velocity,
                },
                &(),
            ),
        }
    }
}

#[test]
fn order_four_in_position_and_velocity() {
    let body = Pushed::new();
    let expected = body.exact(3.0);
    let errors = |steps| {
        let end = end(&body, &body.exact(0.0), 0.0..3.0, steps);
        [
            (end.position - expected.position).amax(),
            (end.velocity - expected.velocity).amax(),
            distance(&end.attitude, &expected.attitude),
            (end.angular_velocity - expected.angular_velocity).amax(),
        ]
    };
    assert_fourth(&orders(60, errors));
    assert!(errors(2000).into_iter().all(|error| error < 1e-10));
}

/// A pendulum in the plane with a drive in time, its G on a circle by hand: (x, y) = (sin θ, -cos θ) is not enforced,
/// only θ has an equation; the position oscillates by itself.
struct Driven;

impl RigidBody for Driven {
    type Scalar = f64;
    type State = Planar;
    type Input = f64;

    /// x'' = -x, y'' = 6 t, θ'' = cos t + input
    fn acceleration(&self, t: f64, state: &Planar, input: &f64) -> PlanarAcceleration {
        PlanarAcceleration {
            linear: Vector2::new(-state.position.x, 6.0 * t),
            angular: t.cos() + input,
        }
    }
}

/// Stage times and inputs arrive where they belong.
#[test]
fn time_and_input() {
    let [from, to]: [f64; 2] = [1.0, 4.0];
    let exact = |t: f64| Planar {
        position: Vector2::new(t.sin(), t.powi(3)),
        angle: -t.cos() + t * t,
        velocity: Vector2::new(t.cos(), 3.0 * t * t),
        angular_velocity: t.sin() + 2.0 * t,
    };
    let errors = |steps| {
        let end = cf4(&Driven, &exact(from), &2.0, from..to, steps);
        let expected = exact(to);
        assert!((end.position.y - expected.position.y).abs() < 1e-11); // a cubic: exact
        [
            (end.position.x - expected.position.x).abs(),
            (end.velocity.x - expected.velocity.x).abs(),
            (end.angle - expected.angle).abs(),
            (end.angular_velocity - expected.angular_velocity).abs(),
        ]
    };
    assert_fourth(&orders(20, errors));
    // And back.
    let there = cf4(&Driven, &exact(from), &2.0, from..to, 2000);
    let back = cf4(&Driven, &there, &2.0, to..from, 2000);
    assert!((back.position - exact(from).position).amax() < 1e-12);
    assert!((back.angle - exact(from).angle).abs() < 1e-12);
    assert_eq!(cf4(&Driven, &there, &0.0, 0.0..1.0, 0), there);
    assert_eq!(
        cf4(&Driven, &there, &0.5, 2.0..3.0, 1),
        cf4_step(&Driven, 2.0, &there, &0.5, 1.0)
    );
}

/// Motions of a point: on straight lines the method is Runge and Kutta's.
#[test]
fn translations() {
    struct Spring;
    impl RigidBody for Spring {
        type Scalar = f64;
        type State = Translation;
        type Input = ();
        fn acceleration(&self, _: f64, state: &Translation, (): &()) -> Vector3<f64> {
            -state.position
        }
    }
    let start = Translation {
        velocity: Vector3::new(1.0, -2.0, 0.5),
        ..Translation::default()
    };
    let errors = |steps| {
        let end = end(&Spring, &start, 0.0..2.0, steps);
        let [position, velocity] = [start.velocity * 2f64.sin(), start.velocity * 2f64.cos()];
        [
            (end.position - position).amax(),
            (end.velocity - velocity).amax(),
        ]
    };
    assert_fourth(&orders(20, errors));
    let planar = PlanarTranslation {
        velocity: Vector2::new(3.0, 4.0),
        ..PlanarTranslation::default()
    };
    let moved = planar.moved(&(planar.rate(&Vector2::new(2.0, 0.0)) * 0.5));
    assert_eq!(
        moved,
        PlanarTranslation {
            position: Vector2::new(1.5, 2.0),
            velocity: Vector2::new(4.0, 4.0)
        }
    );
}

/// H4, and conservation: 1e5 steps.
#[test]
fn attitude_stays_a_rotation() {
    for name in ["asymmetric_free", "lagrange_nutation"] {
        let (body, start) = Turning::read(name);
        let mut state = start;
        for k in 0..100_000 {
            state = cf4_step(&body, 0.0, &state, &(), 1e-3);
            let norm = state.attitude.quaternion().norm();
            assert!(
                (norm - 1.0).abs() <= 4.0 * f64::EPSILON,
                "{name}, step {k}: {norm}"
            );
        }
        // At steps of 3 and 10 mrad: (1e-2)⁴ a radian, over 1000 rad, times about 1/100.
        let drift = (body.energy(&state) - body.energy(&start)) / body.energy(&start);
        assert!(drift.abs() < 1e-7, "{name}: {drift:e}");
        let [before, after] = [start, state].map(|state| body.angular_momentum(&state));
        // About the vertical always, in space if free.
        assert!((before.z - after.z).abs() < 1e-7 * before.norm(), "{name}");
        assert!(
            body.torque != 0.0 || (before - after).norm() < 1e-7 * before.norm(),
            "{name}"
        );
    }
}

/// H8b: exact zeros stay zero, so that rounding excites no flip about the intermediate axis.
#[test]
fn zeros_stay_zero() {
    let start = Rotation {
        angular_velocity: Vector3::y(),
        ..Rotation::default()
    };
    let later = end(
        &Turning::free([1.0, 2.0, 3.0]),
        &start,
        0.0..1000.0,
        100_000,
    );
    assert_eq!(later.angular_velocity, Vector3::y());
    assert_eq!((later.attitude.i, later.attitude.k), (0.0, 0.0));
}
