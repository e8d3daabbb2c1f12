//! The ninth kind of motion: a rod of three mass points on a line, given by its center R and its
//! axis u in space.
//!
//! There is also a Lagrangian for u as a free vector. The condition that its length is one adds a
//! force along it, which is the multiplier:
//!
//! ```text
//! d/dt ∂L/∂V = ∂L/∂R + F        d/dt ∂L/∂u̇ = ∂L/∂u + K × u + s F + λ u
//! ```

use nalgebra::Vector3;
use newton_euler::prelude::*;
use proptest::prelude::*;

use super::bodies::{Stick, StickInput};
use crate::dual::Dual;
use crate::oracle;
use crate::oracle::vectors;

/// Masses and where they are on the axis, from the drawing origin.
const POINTS: [(f64, f64); 3] = [(0.5, 0.9), (0.3, -0.6), (1.1, 0.3)];
const TIP: f64 = -1.2;
const HOOK: f64 = 1.5;

type Triple = [Dual; 3];

fn dot(a: &Triple, b: &Triple) -> Dual {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn at(place: &Triple, axis: &Triple, s: f64) -> Triple {
    [0, 1, 2].map(|i| place[i] + axis[i] * s)
}

fn constant(v: [f64; 3]) -> Triple {
    v.map(Dual::from)
}

/// `Σ ½ m v² + Σ m g·x - ½ k s² + F·x` at R, u, V, u̇, with G at `center`.
fn lagrangian([place, axis, velocity, rate]: &[Triple; 4], center: f64) -> Dual {
    let mut sum = Dual::from(0.0);
    for (mass, s) in POINTS {
        let v = at(velocity, rate, s - center);
        let height = at(place, axis, s - center)[1];
        sum = sum + dot(&v, &v) * (mass / 2.0) + height * (-9.80665 * mass);
    }
    let hook = at(place, axis, HOOK - center);
    let stretch = [(0, 1.5), (1, 2.0), (2, -1.0)].map(|(i, wall)| hook[i] - Dual::from(wall));
    let charge = at(place, axis, TIP - center);
    sum - dot(&stretch, &stretch) * 15.0 + dot(&charge, &constant([3.0, -2.0, 4.0]))
}

proptest! {
    /// Within 1e-13 of the terms: some hundred roundings.
    #[test]
    fn rod(state in oracle::rod(), push in vectors(20.0), thrust in -20.0..20.0, twist in vectors(5.0)) {
        let computed = Stick::default().acceleration(0.0, &state, &StickInput { push, thrust, twist });
        let center = POINTS.iter().map(|(m, s)| m * s).sum::<f64>() / 1.9;
        let (u, rate) = (state.axis.into_inner(), state.axis_rate);
        let values = [state.position, u, state.velocity, rate];
        let rates = [state.velocity, rate, computed.linear, computed.axis];
        // the slope along one coordinate, and its rate
        let slope = |which: usize, i: usize, time: f64| {
            let mut moving = [constant([0.0; 3]); 4];
            for k in 0..4 {
                moving[k] = [0, 1, 2].map(|j| Dual {
                    value: values[k][j],
                    first: if (k, j) == (which, i) { 1.0 } else { 0.0 },
                    second: time * rates[k][j],
                    mixed: 0.0,
                });
            }
            lagrangian(&moving, center)
        };
        let balance = |place: usize, velocity: usize| {
            Vector3::from_fn(|i, _| slope(velocity, i, 1.0).mixed - slope(place, i, 0.0).first)
        };
        let force = push + u * thrust;
        let force_balance = balance(0, 2) - force;
        let across = u.cross(&twist).cross(&u);
        let free = balance(1, 3) - force * (TIP - center) - across.cross(&u);
        let axis_balance = free - u * u.dot(&free);
        let size = 200.0 + 60.0 * state.position.norm() + 4.0 * (computed.linear.norm() + computed.axis.norm());
        prop_assert!(force_balance.amax() < 1e-13 * size, "{force_balance}");
        prop_assert!(axis_balance.amax() < 1e-13 * size, "{axis_balance}");
        // and u stays of length one
        prop_assert!((u.dot(&computed.axis) + rate.norm_squared()).abs() < 1e-13 * size);
    }
}
