//! The slender rod and the hinge: states with five degrees of freedom and with one.

#![allow(
    clippy::float_cmp,
    clippy::cast_precision_loss,
    clippy::excessive_precision,
    reason = "what is exact is compared exactly, with all digits of the references"
)]
use std::f64::consts::TAU;

use nalgebra::{Unit, UnitQuaternion, UnitVector3, Vector3};
use newton_euler::integrate::{cf4, cf4_step};
use newton_euler::prelude::*;
use proptest::prelude::*;

use crate::reference::{number, statement, vector};

/// A uniform rod on a spring from a point of it to the world's origin, in a uniform field: translation and rotation act on
/// each other, and energy is conserved.
struct Sprung {
    mass: f64,
    moment: f64,
    arm: f64,
    stiffness: f64,
    gravity: Vector3<f64>,
}

const SPRUNG: Sprung = Sprung {
    mass: 1.2,
    moment: 0.064,
    arm: 0.3,
    stiffness: 20.0,
    gravity: Vector3::new(0.0, 0.0, -9.8),
};

impl Sprung {
    fn start() -> Rod {
        Rod {
            position: Vector3::new(0.2, -0.1, 0.0),
            velocity: Vector3::new(0.5, 1.0, -0.3),
            axis: Unit::new_unchecked(Vector3::new(0.6, 0.0, 0.8)),
            axis_rate: Vector3::new(0.4, 1.5, -0.3),
        }
    }

    fn force(&self, position: &Vector3<f64>, axis: &Vector3<f64>) -> Vector3<f64> {
        (position + axis * self.arm) * -self.stiffness
    }

    fn energy(&self, rod: &Rod) -> f64 {
        let stretch = rod.position + rod.axis.scale(self.arm);
        0.5 * (self.mass * rod.velocity.norm_squared()
            + self.moment * rod.axis_rate.norm_squared()
            + self.stiffness * stretch.norm_squared())
            - self.mass * self.gravity.dot(&rod.position)
    }
}

impl RigidBody for Sprung {
    type Scalar = f64;
    type State = Rod;
    type Input = ();

    fn acceleration(&self, _: f64, state: &Rod, (): &()) -> RodAcceleration {
        let [u, rate] = [state.axis.into_inner(), state.axis_rate];
        let force = self.force(&state.position, &u);
        let moment = (u * self.arm).cross(&force);
        RodAcceleration {
            linear: force / self.mass + self.gravity,
            axis: moment.cross(&u) / self.moment - u * rate.norm_squared(),
        }
    }
}

/// The same in another formulation: rectangular coordinates and classical Runge-Kutta, the sphere an ambient space.
fn ambient(body: &Sprung, start: &Rod, time: f64, steps: usize) -> [Vector3<f64>; 4] {
    let h = time / steps as f64;
    let rate = |[x, v, u, du]: [Vector3<f64>; 4]| {
        let force = body.force(&x, &u);
        let moment = (u * body.arm).cross(&force);
        let bend = moment.cross(&u) / body.moment - u * du.norm_squared();
        [v, force / body.mass + body.gravity, du, bend]
    };
    let add = |y: [Vector3<f64>; 4], k: [Vector3<f64>; 4], h: f64| {
        std::array::from_fn::<_, 4, _>(|i| y[i] + k[i] * h)
    };
    let axis = start.axis.into_inner();
    let mut y = [start.position, start.velocity, axis, start.axis_rate];
    for _ in 0..steps {
        let k1 = rate(y);
        let k2 = rate(add(y, k1, h / 2.0));
        let k3 = rate(add(y, k2, h / 2.0));
        let k4 = rate(add(y, k3, h));
        for (k, weight) in [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)] {
            y = add(y, k, weight * h / 6.0);
        }
    }
    y
}

/// D: ü = (K × u)/J - |u̇|² u, by the motion through this state.
#[test]
fn slender_rod() {
    struct Pulled {
        moment: f64,
        force: Vector3<f64>,
    }
    impl RigidBody for Pulled {
        type Scalar = f64;
        type State = Rod;
        type Input = ();

        /// The force on the end at u; ü without its component along u, which is not read.
        fn acceleration(&self, _: f64, state: &Rod, (): &()) -> RodAcceleration {
            let moment = state.axis.cross(&self.force);
            RodAcceleration {
                axis: moment.cross(&state.axis) / self.moment,
                ..RodAcceleration::default()
            }
        }
    }
    let expected = statement("degenerate slender rod J=(0,J,J), J=mL^2/12");
    let [u, axis_rate, moment, acceleration] =
        ["u", "udot", "K=ux(.7,-.2,.1)", "uddot"].map(|name| vector(&expected[name]));
    let body = Pulled {
        moment: number(&expected["J"]),
        force: Vector3::new(0.7, -0.2, 0.1),
    };
    assert!((u.cross(&body.force) - moment).amax() < 1e-16);
    let rod = Rod {
        axis: Unit::new_unchecked(u),
        axis_rate,
        ..Rod::default()
    };

    // Differences over h: h²/12 of the fourth derivative, some 200; rounding 1e-16/h².
    let h = 1e-4;
    let [before, after] = [-h, h].map(|h| cf4_step(&body, 0.0, &rod, &(), h));
    let [a, b] = [before, after].map(|rod| rod.axis.into_inner());
    assert!(((b - a) / (2.0 * h) - axis_rate).amax() < 1e-6);
    assert!(((a - u * 2.0 + b) / (h * h) - acceleration).amax() < 1e-6);
    let second = (after.axis_rate - before.axis_rate) / (2.0 * h);
    assert!((second - acceleration).amax() < 1e-6);

    // With its component along u, the same.
    let bare = body.acceleration(0.0, &rod, &());
    let full = RodAcceleration {
        axis: acceleration,
        ..bare
    };
    assert!((bare.axis - u * axis_rate.norm_squared() - acceleration).amax() < 1e-14);
    assert!((rod.rate(&full) - rod.rate(&bare)).amax() < 4e-15);
}

/// Order four in every coordinate, against another formulation at a hundredth of the step.
#[test]
fn order_four() {
    let start = Sprung::start();
    let [position, velocity, axis, axis_rate] = ambient(&SPRUNG, &start, 2.0, 20_000);
    let errors = |steps: usize| {
        let end = cf4(&SPRUNG, &start, &(), 0.0..2.0, steps);
        [
            (end.position - position).amax(),
            (end.velocity - velocity).amax(),
            (end.axis.into_inner() - axis).amax(),
            (end.axis_rate - axis_rate).amax(),
        ]
    };
    // Three halvings from steps of 10 mrad or so; each must gain 16, up to the next order.
    let runs: Vec<[f64; 4]> = (0..4).map(|k| errors(100 << k)).collect();
    for coordinate in 0..4 {
        for pair in runs.windows(2) {
            let order = (pair[0][coordinate] / pair[1][coordinate]).log2();
            assert!(
                (3.6..4.4).contains(&order),
                "coordinate {coordinate}: {order}"
            );
        }
        assert!(runs[3][coordinate] < 1e-6);
    }
    assert!(errors(6400).into_iter().all(|error| error < 1e-10));
}

/// The same rod with a spatial state, and a moment of inertia about its axis that no load reaches.
#[test]
fn as_a_body_that_does_not_spin() {
    struct Solid;
    impl RigidBody for Solid {
        type Scalar = f64;
        type State = Spatial;
        type Input = ();

        fn acceleration(&self, _: f64, state: &Spatial, (): &()) -> SpatialAcceleration {
            let moments = Vector3::new(0.01, SPRUNG.moment, SPRUNG.moment);
            let w = state.angular_velocity;
            let force = SPRUNG.force(&state.position, &(state.attitude * Vector3::x()));
            let moment = (Vector3::x() * SPRUNG.arm).cross(&(state.attitude.inverse() * force));
            SpatialAcceleration {
                linear: force / SPRUNG.mass + SPRUNG.gravity,
                angular: (moment - w.cross(&moments.component_mul(&w))).component_div(&moments),
            }
        }
    }
    let rod = Sprung::start();
    let attitude = UnitQuaternion::rotation_between(&Vector3::x(), &rod.axis).unwrap();
    let start = Spatial {
        position: rod.position,
        velocity: rod.velocity,
        attitude,
        angular_velocity: attitude.inverse() * rod.angular_velocity(),
    };
    let solid = cf4(&Solid, &start, &(), 0.0..2.0, 5000);
    let end = cf4(&SPRUNG, &rod, &(), 0.0..2.0, 5000);
    assert!((solid.position - end.position).amax() < 1e-9);
    assert!((solid.attitude * Vector3::x() - end.axis.into_inner()).amax() < 1e-9);
    let w = solid.attitude * solid.angular_velocity;
    assert!((w - end.angular_velocity()).amax() < 1e-8);
}

/// H1, and both conditions: 1e5 steps.
#[test]
fn stays_a_rod() {
    let mut rod = Sprung::start();
    let energy = SPRUNG.energy(&rod);
    for k in 0..100_000 {
        rod = cf4_step(&SPRUNG, 0.0, &rod, &(), 1e-3);
        assert!(
            (rod.axis.norm() - 1.0).abs() <= 2.0 * f64::EPSILON,
            "step {k}"
        );
        let along = rod.axis.dot(&rod.axis_rate);
        assert!(
            along.abs() <= 4.0 * f64::EPSILON * rod.axis_rate.norm(),
            "step {k}: {along:e}"
        );
    }
    // Steps of 20 mrad at the fastest: (2e-2)⁴/100 of 2000 rad.
    assert!((SPRUNG.energy(&rod) / energy - 1.0).abs() < 1e-6);
}

/// Left alone: a great circle, without error in any step.
#[test]
fn free_rod() {
    struct Free;
    impl RigidBody for Free {
        type Scalar = f64;
        type State = Rod;
        type Input = ();
        fn acceleration(&self, _: f64, state: &Rod, (): &()) -> RodAcceleration {
            RodAcceleration {
                axis: -state.axis.scale(state.axis_rate.norm_squared()),
                ..RodAcceleration::default()
            }
        }
    }
    let start = Sprung::start();
    let speed = start.axis_rate.norm();
    for (turns, steps) in [(1.0, 1), (0.3, 1), (-0.3, 2), (3.0, 1000), (10.0, 7)] {
        let angle = TAU * turns;
        let end = cf4(&Free, &start, &(), 0.0..angle / speed, steps);
        let along = start.axis_rate / speed;
        let axis = start.axis.scale(angle.cos()) + along * angle.sin();
        let rate = along * angle.cos() - start.axis.scale(angle.sin());
        // A few roundings of the speed, which the angle grows with.
        let error = f64::EPSILON * (10.0 + 4.0 * angle.abs());
        assert!((end.axis.into_inner() - axis).amax() < error, "{turns}");
        assert!(
            (end.axis_rate - rate * speed).amax() < error * speed,
            "{turns}"
        );
    }
    // At rest, exactly.
    let rest = Rod {
        axis_rate: Vector3::zeros(),
        velocity: Vector3::zeros(),
        ..start
    };
    assert_eq!(cf4(&Free, &rest, &(), 0.0..1e3, 10).position, rest.position);
    assert!(
        (cf4(&Free, &rest, &(), 0.0..1e3, 10).axis.into_inner() - rest.axis.into_inner()).amax()
            < 3e-16
    );
    let along_x = Rod::default();
    assert_eq!(cf4(&Free, &along_x, &(), 0.0..1.0, 1000), along_x);
}

/// A pendulum by a hinge: swing from rest at 90°, whose quarter period is K(1/2)/ω₀ = 1.854 074 677 301 371 9/ω₀.
#[test]
fn hinge() {
    struct Pendulum;
    impl RigidBody for Pendulum {
        type Scalar = f64;
        type State = Hinge;
        type Input = f64;
        fn acceleration(&self, _: f64, state: &Hinge, torque: &f64) -> f64 {
            torque - state.angle.sin()
        }
    }
    let raised = Hinge {
        angle: TAU / 4.0,
        angular_velocity: 0.0,
    };
    let quarter = 1.854_074_677_301_371_9;
    let errors: Vec<f64> = [50, 100, 200]
        .map(|steps| cf4(&Pendulum, &raised, &0.0, 0.0..quarter, steps))
        .map(|low| low.angle.abs() + (low.angular_velocity + 2f64.sqrt()).abs())
        .into();
    assert!((errors[0] / errors[1]).log2() > 3.7 && (errors[1] / errors[2]).log2() > 3.7);
    let low = cf4(&Pendulum, &raised, &0.0, 0.0..quarter, 5000);
    assert!(low.angle.abs() < 1e-13 && (low.angular_velocity + 2f64.sqrt()).abs() < 1e-13);
    let held = cf4(&Pendulum, &raised, &1.0, 0.0..10.0, 100);
    assert!((held.angle - raised.angle).abs() < 1e-15);
    assert_eq!(Hinge::default().rate(&2.0)[1], 2.0);
}

fn some_vector() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0).prop_map(Vector3::from)
}

fn some_axis() -> impl Strategy<Value = UnitVector3<f64>> {
    some_vector()
        .prop_filter("of some length", |v| v.norm() > 0.1)
        .prop_map(Unit::new_normalize)
}

proptest! {
    /// A displacement is the flow of a constant element of the algebra: its halves compose to it, and it goes back. Small
    /// and large turns meet in one formula.
    #[test]
    fn one_parameter_groups(
        axis in some_axis(),
        [rate, turn, change] in [some_vector(), some_vector(), some_vector()],
        decade in -9..2,
    ) {
        let rod = Rod { axis, axis_rate: axis.cross(&rate), ..Rod::default() };
        let mut displacement = rod.rate(&RodAcceleration::default());
        displacement.fixed_rows_mut::<3>(3).copy_from(&(turn * 10f64.powi(decade)));
        displacement.fixed_rows_mut::<3>(9).copy_from(&change);
        let whole = rod.moved(&displacement);
        let halves = rod.moved(&(displacement * 0.5)).moved(&(displacement * 0.5));
        let back = whole.moved(&(displacement * -1.0));
        // Turns of up to 17 rad are known to 2e-15.
        for (one, other) in [(&whole, &halves), (&back, &rod)] {
            prop_assert!((one.axis.into_inner() - other.axis.into_inner()).amax() < 1e-14);
            prop_assert!((one.axis_rate - other.axis_rate).amax() < 2e-14);
        }
        prop_assert!(whole.axis.dot(&whole.axis_rate).abs() < 1e-15);
    }
}
