//! Two wheels under the constraint `sin a + 3 b = 0`.

use newton_euler::constrained::{Constrained, Inconsistent, Violation};
use newton_euler::integrate::{DormandPrince, Projected};
use newton_euler::prelude::*;
use newton_euler::private::{Row, Size, check, project};
use newton_euler::state::List;

newton_euler::private::system_state! {
    /// The state of [`Geared`] wheels.
    GearedState
    /// The acceleration of [`Geared`] wheels.
    GearedAcceleration {
        first: Hinge => f64,
        second: Hinge => f64,
    }
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Geared;

/// The constraint, its rate, and its slope in the first angle.
fn gear(state: &GearedState) -> [f64; 3] {
    let (sine, cosine) = state.first.angle.sin_cos();
    [
        sine + 3.0 * state.second.angle,
        cosine * state.first.angular_velocity + 3.0 * state.second.angular_velocity,
        cosine,
    ]
}

impl RigidBody for Geared {
    type Scalar = f64;
    type State = GearedState;
    type Input = ();

    fn acceleration(&self, time: f64, state: &GearedState, (): &()) -> GearedAcceleration {
        let [_, _, slope] = gear(state);
        let free = [time.cos(), -2.0 * state.second.angle];
        let rate = state.first.angular_velocity;
        let bent = -state.first.angle.sin() * rate * rate;
        let push = -(slope * free[0] + 3.0 * free[1] + bent) / (slope * slope + 9.0);
        GearedAcceleration {
            first: free[0] + slope * push,
            second: free[1] + 3.0 * push,
        }
    }
}

impl Integrate for Geared {
    type Best = Projected<DormandPrince>;
}

impl Constrained for Geared {
    type Violations = [Violation; 1];

    fn violations(&self, _time: f64, state: &GearedState, (): &()) -> [Violation; 1] {
        let [position, velocity, _] = gear(state);
        let (name, position) = ("gear", Some(position));
        [Violation {
            name,
            position,
            velocity,
        }]
    }

    fn check(&self, _time: f64, state: &GearedState, (): &()) -> Result<(), Inconsistent> {
        let [position, velocity, _] = gear(state);
        check(&[Size {
            name: "gear",
            position: Some((position, 3.0)),
            facing: 1.0,
            velocity: (velocity, 3.0),
        }])
    }

    fn project(&self, _time: f64, state: &mut GearedState, (): &()) -> Result<(), Inconsistent> {
        project(state, |state| {
            let [position, velocity, slope] = gear(state);
            [Row {
                name: "gear",
                position: Some((position, 3.0)),
                facing: 1.0,
                velocity: (velocity, 3.0),
                shift: List([slope, 3.0, 0.0, 0.0]),
                push: List([0.0, 0.0, slope, 3.0]),
                coupling: [slope * slope + 9.0],
                part: 0,
                follows: false,
            }]
        })
    }
}
