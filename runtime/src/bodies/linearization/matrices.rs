//! The blocks of a linearization as matrices, and their modes.

use nalgebra::allocator::Allocator;
use nalgebra::{Const, DefaultAllocator, DimDiff, DimSub, SMatrix, U1};

use super::balanced::Balanced;
use super::modes::Modes;
use crate::bodies::body::{RigidBody, Unrequested, unrequested};

/// The first derivatives of the motion of a body or a system, `outputs: [linearization]`.
///
/// ```
/// use newton_euler::prelude::*;
///
/// rigid_body!(Pendulum {
///     motion: pivot(hinge),
///     mass: 2[kg],
///     inertia: 0.1[kg * m ^ 2],
///     points: [hinge = (0, 0.5)],
///     inputs: [torque[N * m]],
///     fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
///     moments: [motor = torque],
///     outputs: [linearization],
/// });
///
/// let hanging = Pendulum::default().linearize(0.0, &Hinge::default(), &PendulumInput { torque: 0.0 });
/// let about_hinge = 0.1 + 2.0 * 0.5 * 0.5;
/// assert!((hanging.angular_by_torque * about_hinge - 1.0).abs() < 1e-15);
/// assert!((hanging.angular_by_angle * about_hinge + 2.0 * 9.80665 * 0.5).abs() < 1e-14);
/// // as x' = A x + B u, and in steps of 1 ms
/// let (a, b) = (hanging.a(), hanging.b());
/// assert_eq!([a[(0, 1)], a[(1, 0)], b[(1, 0)]], [1.0, hanging.angular_by_angle, hanging.angular_by_torque]);
/// let (step, push) = hanging.discretized(1e-3);
/// assert!((step[(0, 1)] - 1e-3).abs() < 1e-8 && (push[(0, 0)] - 5e-7 * b[(1, 0)]).abs() < 1e-11);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `linearization`",
    label = "add `linearization` to its `outputs`"
)]
pub trait Linearization: RigidBody {
    /// A struct of the acceleration and of all blocks that are not zero in all states:
    /// `linear_by_attitude`, `angular_by_torque`, for a system `elbow_angular_by_shoulder_angle`. A
    /// block is a number, or a matrix with a row for each component of the acceleration. The struct
    /// is [`Linearized`].
    type Linearization;

    /// The derivatives in this state. At a kink of the motion (`abs`, `min`, `if`), they are those
    /// of the active branch.
    fn linearize(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Linearization;
}

#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `linearization`",
    label = "add `linearization` to its `outputs`"
)]
pub trait LinearizationInOutputs: Unrequested {}

unrequested! {
    impl Linearization for LinearizationInOutputs {
        type Linearization = ();
        fn linearize(Self::Scalar, &Self::State, &Self::Input) -> ();
    }
}

/// `x' = A x + B u`: a linearization as matrices, in doubles.
pub trait Linearized<const STATES: usize, const INPUTS: usize> {
    /// The names of the coordinates of the tangent space: `position_x`, `elbow_angle`.
    const STATES: [&'static str; STATES];
    /// The names of the components of the input.
    const INPUTS: [&'static str; INPUTS];
    /// The entries of A that may be nonzero.
    const A_PATTERN: [[bool; STATES]; STATES];
    /// The entries of B that may be nonzero.
    const B_PATTERN: [[bool; INPUTS]; STATES];

    /// A: the derivatives of the rates of the coordinates with respect to the coordinates.
    fn a(&self) -> SMatrix<f64, STATES, STATES>;

    /// B: the derivatives of the rates of the coordinates with respect to the input.
    fn b(&self) -> SMatrix<f64, STATES, INPUTS>;

    /// `x(t + h) = P x(t) + Q u`, with u held for the step h \[s\]:
    ///
    /// ```text
    /// P = exp(A h),    Q = (integral from 0 to h of exp(A s) ds) B
    /// ```
    ///
    /// to rounding: A is balanced by powers of two (B. Parlett and C. Reinsch, Balancing a matrix
    /// for calculation of eigenvalues and eigenvectors); then Taylor's series on a step so short
    /// that `|A h| <= 1/2` is doubled as often as necessary (scaling and squaring; C. Moler and
    /// C. Van Loan, Nineteen dubious ways to compute the exponential of a matrix). Rounding grows
    /// with the number of doublings: an oscillation loses as many digits as its phase in the step has
    /// before the decimal point. The result is NaN if A is not finite, or if the exponential
    /// overflows.
    fn discretized(
        &self,
        step: f64,
    ) -> (SMatrix<f64, STATES, STATES>, SMatrix<f64, STATES, INPUTS>) {
        let Some(balanced) = Balanced::of(&self.a()) else {
            return (SMatrix::repeat(f64::NAN), SMatrix::repeat(f64::NAN));
        };
        let (a, scales) = (balanced.matrix * balanced.scale, balanced.diagonal);
        let mut b = self.b();
        for (mut row, scale) in b.row_iter_mut().zip(&scales) {
            row /= *scale;
        }
        let size = one_norm(&a) * step.abs();
        let mut doublings = 0;
        let mut short = step;
        // beyond this, the exponential overflows
        while size * (short / step).abs() > 0.5 && doublings < 1100 {
            short *= 0.5;
            doublings += 1;
        }
        let one = SMatrix::identity();
        let (mut power, mut integral) = (one, one * short);
        let mut term = integral;
        for order in 2..20_u8 {
            term = a * term * (short / f64::from(order));
            integral += term;
        }
        power += a * integral;
        for _ in 0..doublings {
            integral += power * integral;
            power = power * power;
        }
        let mut push = integral * b;
        for (row, scale) in scales.iter().enumerate() {
            power.row_mut(row).scale_mut(*scale);
            push.row_mut(row).scale_mut(*scale);
        }
        for (mut column, scale) in power.column_iter_mut().zip(&scales) {
            column /= *scale;
        }
        (power, push)
    }

    /// The modes of `x' = A x`: its eigenvalues. They describe the motion if A stays constant, as
    /// in a steady motion found by [`trim`](super::Trim::trim); for a steady turn use
    /// [`Trimmed::modes`](super::Trimmed::modes). Under constraints they include directions that no
    /// motion takes; those of a trimmed body do not.
    ///
    /// Parts of A that do not have an effect on each other and back have their own modes. The
    /// eigenvalues come from the Schur form of each balanced part, after removing neutral
    /// directions. Real parts are zero if a change of the balanced part within rounding makes them
    /// so: no more than the number of its states times ten units of rounding, as a fraction of its
    /// norm. A mode 1e13 times slower than another in its part counts as neutral. `None` if A is not
    /// finite.
    ///
    /// ```
    /// use newton_euler::prelude::*;
    ///
    /// rigid_body!(Pendulum {
    ///     motion: pivot(hinge),
    ///     mass: 2[kg],
    ///     inertia: 0.1[kg * m ^ 2],
    ///     points: [hinge = (0, 0.5)],
    ///     fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    ///     moments: [damper = -0.3[N * m * s] * angular_velocity],
    ///     outputs: [linearization],
    /// });
    ///
    /// let hanging = Pendulum::default().linearize(0.0, &Hinge::default(), &());
    /// let modes = hanging.modes().expect("A is finite");
    /// let frequency = (2.0 * 9.80665 * 0.5 / 0.6_f64).sqrt();
    /// assert_eq!(modes.len(), 1);
    /// assert!((modes[0].natural_frequency() - frequency).abs() < 1e-14);
    /// assert!((modes[0].damping_ratio() - 0.3 / 0.6 / 2.0 / frequency).abs() < 1e-15);
    /// ```
    fn modes(&self) -> Option<Modes<STATES>>
    where
        Const<STATES>: DimSub<U1>,
        DefaultAllocator: Allocator<Const<STATES>, DimDiff<Const<STATES>, U1>>
            + Allocator<DimDiff<Const<STATES>, U1>>,
    {
        Modes::of(&self.a(), STATES, 0.0)
    }
}

/// The largest column sum of absolute values.
fn one_norm<const N: usize>(matrix: &SMatrix<f64, N, N>) -> f64 {
    let columns = matrix.column_iter();
    let sums = columns.map(|column| column.iter().map(|entry| entry.abs()).sum::<f64>());
    sums.fold(0.0, |largest, sum| {
        if sum > largest || sum.is_nan() {
            sum
        } else {
            largest
        }
    })
}

#[doc(hidden)]
/// A matrix with the entries that all motions share: the rates of the leading coordinates, of the
/// given number.
#[must_use]
pub fn rates_of_places<const STATES: usize>(places: usize) -> SMatrix<f64, STATES, STATES> {
    let mut matrix = SMatrix::zeros();
    for place in 0..places {
        matrix[(place, place + places)] = 1.0;
    }
    matrix
}

#[doc(hidden)]
/// Puts a block into a matrix.
pub fn place<const ROWS: usize, const COLUMNS: usize, const R: usize, const C: usize>(
    matrix: &mut SMatrix<f64, ROWS, COLUMNS>,
    [row, column]: [usize; 2],
    block: &SMatrix<f64, R, C>,
) {
    matrix.fixed_view_mut::<R, C>(row, column).copy_from(block);
}
