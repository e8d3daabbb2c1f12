//! Two bars, one of which hangs from the other.

use newton_euler::Scalar;
use newton_euler::columns::{Columns, Generic, Sink, Source};
use newton_euler::integrate::DormandPrince;
use newton_euler::prelude::*;

use super::number;

newton_euler::private::system_state! {
    /// The state of a [`DoublePendulum`].
    DoublePendulumState
    /// The acceleration of a [`DoublePendulum`].
    DoublePendulumAcceleration <T> {
        /// The upper bar beside the ground; zero where it hangs.
        shoulder: Hinge
            /// \[rad/s²\]
            => T,
        /// The lower bar beside the upper one.
        elbow: Hinge
            /// \[rad/s²\]
            => T,
    }
}

/// Masses, moments of inertia about the centers, lengths to these, and of the upper bar:
///
/// ```text
/// L = I₁ q'²/2 + m₁ c₁² q'²/2 + I₂ (q' + e')²/2 + m₂ v₂²/2 + (m₁ c₁ + m₂ l) g cos q + m₂ c₂ g cos (q + e)
/// v₂² = l² q'² + c₂² (q' + e')² + 2 l c₂ q' (q' + e') cos e
/// ```
#[derive(Clone, Copy, Debug)]
pub struct DoublePendulum<T: Scalar> {
    pub gravity: T,
}

pub const MASSES: [f64; 2] = [1.2, 0.8];
pub const MOMENTS: [f64; 2] = [0.04, 0.015];
pub const CENTERS: [f64; 2] = [0.28, 0.22];
pub const LENGTH: f64 = 0.6;

/// What a motor in the elbow gives \[N m\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoublePendulumInput<T: Scalar> {
    pub motor: T,
}

impl<T: Scalar> Default for DoublePendulum<T> {
    fn default() -> Self {
        Self {
            gravity: number(T::default(), 9.80665),
        }
    }
}

impl<T: Scalar> RigidBody for DoublePendulum<T> {
    type Scalar = T;
    type State = DoublePendulumState<T>;
    type Input = DoublePendulumInput<T>;

    #[inline(always)]
    fn acceleration(
        &self,
        _time: T,
        state: &Self::State,
        input: &Self::Input,
    ) -> DoublePendulumAcceleration<T> {
        let [m1, m2] = MASSES;
        let [c1, c2] = CENTERS;
        let (q, dq) = (state.shoulder.angle, state.shoulder.angular_velocity);
        let (e, de) = (state.elbow.angle, state.elbow.angular_velocity);
        let (sine, cosine) = e.sin_cos();
        let coupling = number(q, m2 * LENGTH * c2);
        let far = number(q, MOMENTS[1] + m2 * c2 * c2);
        let near = number(q, MOMENTS[0] + m1 * c1 * c1 + m2 * LENGTH * LENGTH);
        let mixed = far + coupling * cosine;
        let all = near + mixed + coupling * cosine;
        let lower = number(q, m2 * c2) * self.gravity * (q + e).sin();
        let upper = number(q, m1 * c1 + m2 * LENGTH) * self.gravity * q.sin() + lower;
        let swing = coupling * sine;
        let first = swing * de * (dq + dq + de) - upper;
        let second = input.motor - swing * dq * dq - lower;
        let determinant = all * far - mixed * mixed;
        DoublePendulumAcceleration {
            shoulder: (far * first - mixed * second) / determinant,
            elbow: (all * second - mixed * first) / determinant,
        }
    }
}

impl Integrate for DoublePendulum<f64> {
    type Best = DormandPrince;
}

impl DoublePendulum<f64> {
    /// Kinetic and potential \[J\].
    pub fn energy(self, state: &DoublePendulumState<f64>) -> f64 {
        let (q, dq) = (state.shoulder.angle, state.shoulder.angular_velocity);
        let turn = dq + state.elbow.angular_velocity;
        let ([m1, m2], [c1, c2]) = (MASSES, CENTERS);
        let square = (LENGTH * dq).powi(2)
            + (c2 * turn).powi(2)
            + 2.0 * LENGTH * c2 * dq * turn * state.elbow.angle.cos();
        let moving =
            0.5 * ((MOMENTS[0] + m1 * c1 * c1) * dq * dq + MOMENTS[1] * turn * turn + m2 * square);
        let height = (m1 * c1 + m2 * LENGTH) * q.cos() + m2 * c2 * (q + state.elbow.angle).cos();
        moving - self.gravity * height
    }
}

impl<T: Scalar> Columns<T> for DoublePendulum<T> {
    const COUNT: usize = 1;

    #[inline(always)]
    fn read(source: &mut impl Source<T>) -> Self {
        Self {
            gravity: source.take(),
        }
    }

    #[inline(always)]
    fn write(&self, sink: &mut impl Sink<T>) {
        sink.put(self.gravity);
    }
}

impl<T: Scalar> Columns<T> for DoublePendulumInput<T> {
    const COUNT: usize = 1;

    #[inline(always)]
    fn read(source: &mut impl Source<T>) -> Self {
        Self {
            motor: source.take(),
        }
    }

    #[inline(always)]
    fn write(&self, sink: &mut impl Sink<T>) {
        sink.put(self.motor);
    }
}

impl Generic for DoublePendulum<f64> {
    type With<T: Scalar> = DoublePendulum<T>;
    type Params = f64;

    fn build(gravity: f64) -> Result<Self, InvalidBody> {
        Ok(Self { gravity })
    }

    fn parameters(&self) -> f64 {
        self.gravity
    }
}
