//! The Lagrangian and Lagrange's equations.

use nalgebra::{Matrix3, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;

use crate::dual::Dual;

type Triple = [Dual; 3];

/// Where P is and which way the body is turned, and how both change.
struct Moving {
    place: Triple,
    turn: [Triple; 3],
    velocity: Triple,
    rate: Triple,
}

fn cross(a: &Triple, b: &Triple) -> Triple {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
}

fn dot(a: &Triple, b: &Triple) -> Dual {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn plus(a: &Triple, b: &Triple) -> Triple {
    [0, 1, 2].map(|i| a[i] + b[i])
}

fn turned(turn: &[Triple; 3], v: &Triple) -> Triple {
    turn.each_ref().map(|row| dot(row, v))
}

/// `R (1 + φ×)`, φ infinitesimal, in body axes.
fn turned_on(turn: &[Triple; 3], by: &Triple) -> [Triple; 3] {
    // the rows of R φ× are -φ × row
    turn.each_ref().map(|row| plus(row, &cross(row, by)))
}

fn constant(v: Vector3<f64>) -> Triple {
    [v.x, v.y, v.z].map(Dual::from)
}

/// Masses and their places from G, in body axes.
const POINTS: [(f64, [f64; 3]); 5] = [
    (0.5, [0.3, -0.2, 0.1]),
    (0.3, [-0.4, 0.5, 0.2]),
    (0.4, [0.25, 0.35, -0.3]),
    (0.2, [-0.1, -0.6, 0.4]),
    (0.5, [-0.22, -0.14, -0.14]),
];

const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.80665, 0.0);
/// A spring without rest length, from a point of the body to one in space.
const STIFFNESS: f64 = 30.0;
const HOOK: Vector3<f64> = Vector3::new(0.5, 0.25, -0.2);
const WALL: Vector3<f64> = Vector3::new(1.5, 2.0, -1.0);
/// A uniform field on a charge.
pub const FIELD: Vector3<f64> = Vector3::new(3.0, -2.0, 4.0);
const CHARGE: Vector3<f64> = Vector3::new(0.3, -0.4, 0.2);
/// Where a force acts that turns with the body.
const TIP: Vector3<f64> = Vector3::new(-0.3, 0.2, 0.4);

/// What stands where the motion of a body is compared.
pub struct Scene {
    /// P, from G.
    pub origin: Vector3<f64>,
    /// Whether it hangs and is pulled by the spring: not, if the motion of G is not modeled.
    pub is_placed: bool,
    pub push: Vector3<f64>,
    pub twist: Vector3<f64>,
}

impl Scene {
    /// `Σ ½ m v² + Σ m g·x - ½ k s² + F·x`
    fn lagrangian(&self, at: &Moving) -> Dual {
        let from_origin = |r: Vector3<f64>| constant(r - self.origin);
        let place = |r| plus(&at.place, &turned(&at.turn, &from_origin(r)));
        let mut sum = dot(&place(CHARGE), &constant(FIELD));
        for (mass, r) in POINTS {
            let r = Vector3::from(r);
            let swept = turned(&at.turn, &cross(&at.rate, &from_origin(r)));
            let velocity = plus(&at.velocity, &swept);
            sum = sum + dot(&velocity, &velocity) * (mass / 2.0);
            if self.is_placed {
                sum = sum + dot(&place(r), &constant(GRAVITY)) * mass;
            }
        }
        if self.is_placed {
            let stretch = plus(&place(HOOK), &constant(-WALL));
            sum = sum - dot(&stretch, &stretch) * (STIFFNESS / 2.0);
        }
        sum
    }

    /// Both residuals are these reactions, within 1e-13 of the terms: some hundred roundings, of points within 1 m.
    pub fn is_balanced(
        &self,
        state: &Spatial,
        [linear, angular]: [Vector3<f64>; 2],
        [force, moment]: [Vector3<f64>; 2],
    ) -> Result<(), TestCaseError> {
        let [expected_force, expected_moment] = self.residual(state, linear, angular);
        let stretch = if self.is_placed {
            state.position.norm() + 4.0
        } else {
            0.0
        };
        let size = 2.0 * (linear.norm() + angular.norm() + state.angular_velocity.norm_squared())
            + STIFFNESS * stretch
            + self.push.norm()
            + self.twist.norm()
            + 25.0;
        let error = (expected_force - force).amax();
        prop_assert!(
            error <= 1e-13 * size,
            "{expected_force} is not {force}: {}",
            error / size
        );
        let error = (expected_moment - moment).amax();
        prop_assert!(
            error <= 1e-13 * size,
            "{expected_moment} is not {moment}: {}",
            error / size
        );
        Ok(())
    }

    /// The left sides less the right ones: force in world axes, moment about P in body axes.
    pub fn residual(
        &self,
        state: &Spatial,
        linear: Vector3<f64>,
        angular: Vector3<f64>,
    ) -> [Vector3<f64>; 2] {
        let (q, w) = (state.attitude, state.angular_velocity);
        let matrix: Matrix3<f64> = q.to_rotation_matrix().into_inner();
        // P is not where G is
        let arm = self.origin;
        let velocity = state.velocity + q * w.cross(&arm);
        let acceleration = linear + q * (angular.cross(&arm) + w.cross(&w.cross(&arm)));
        let at = |time: f64,
                  slide: Vector3<f64>,
                  phi: Vector3<f64>,
                  faster: Vector3<f64>,
                  spin: Vector3<f64>| {
            let mixed =
                |value: Vector3<f64>, first: Vector3<f64>, second: Vector3<f64>| -> Triple {
                    [0, 1, 2].map(|i| Dual {
                        value: value[i],
                        first: first[i],
                        second: time * second[i],
                        mixed: 0.0,
                    })
                };
            let zero = Vector3::zeros();
            let still = [0, 1, 2].map(|i| constant(matrix.row(i).transpose()));
            Moving {
                place: mixed(state.position + q * arm, slide, velocity),
                turn: turned_on(&still, &mixed(zero, phi, w)),
                velocity: mixed(velocity, faster, acceleration),
                rate: mixed(w, spin, angular),
            }
        };
        let zero = Vector3::zeros();
        let unit = |i: usize| Vector3::ith(i, 1.0);
        let each = |f: &dyn Fn(Vector3<f64>) -> f64| Vector3::from_fn(|i, _| f(unit(i)));
        let l = |moving: Moving| self.lagrangian(&moving);
        let momentum_rate = each(&|e| l(at(1.0, zero, zero, e, zero)).mixed);
        let slope = each(&|e| l(at(0.0, e, zero, zero, zero)).first);
        let spin_rate = each(&|e| l(at(1.0, zero, zero, zero, e)).mixed);
        let spin = each(&|e| l(at(0.0, zero, zero, zero, e)).first);
        let turning = each(&|e| l(at(0.0, zero, e, zero, zero)).first);
        let moment = (TIP - self.origin).cross(&self.push) + self.twist;
        [
            momentum_rate - slope - q * self.push,
            spin_rate + w.cross(&spin) - turning - moment,
        ]
    }
}
