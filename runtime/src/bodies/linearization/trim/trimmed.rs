//! A steady motion that was found.

use nalgebra::allocator::Allocator;
use nalgebra::{Const, DefaultAllocator, DimDiff, DimSub, SMatrix, SVector, U1};

use super::slopes::SLOPES;
use crate::bodies::linearization::coordinated::Coordinated;
use crate::bodies::linearization::modes::{Modes, restricted};

/// A steady motion.
#[derive(Clone, Copy, Debug)]
pub struct Trimmed<B: Coordinated<N, M>, const N: usize, const M: usize> {
    /// The state, with the free quantities solved for.
    pub state: B::State,
    /// The input, likewise.
    pub input: B::Input,
    /// The linearization there, as given by [`linearize`](crate::linearization::Linearization::linearize).
    pub linearization: B::Linearization,
    /// The number of ways to change the free quantities without leaving the steady motions, to
    /// first order: zero if the solution is isolated.
    pub undetermined: usize,
    pub(super) matrix: SMatrix<f64, N, N>,
    pub(super) rate: SVector<f64, N>,
    pub(super) constraints: SMatrix<f64, N, N>,
}

impl<B: Coordinated<N, M>, const N: usize, const M: usize> Trimmed<B, N, M> {
    /// The modes of small motions about the steady one, as seen in axes that turn with it; under
    /// constraints only the possible ones. `None` if the derivatives are not finite.
    #[must_use]
    pub fn modes(&self) -> Option<Modes<N>>
    where
        Const<N>: DimSub<U1>,
        DefaultAllocator:
            Allocator<Const<N>, DimDiff<Const<N>, U1>> + Allocator<DimDiff<Const<N>, U1>>,
    {
        let (matrix, size) = restricted(&self.matrix, &self.constraints, SLOPES);
        let noise = if size < N { SLOPES } else { 0.0 };
        Modes::of(&matrix, size, noise)
    }

    /// The rates of the accelerations along the motion, in the order of the rates in
    /// [`Linearized::STATES`](crate::linearization::Linearized::STATES). The motion stays steady if
    /// they are zero. They are not for a climb through air of decreasing density, or a turn about an
    /// axis that is not vertical.
    #[must_use]
    pub fn drift(&self) -> SVector<f64, N> {
        let mut drift = self.matrix * self.rate;
        drift.rows_mut(0, B::PLACES.len()).fill(0.0);
        drift
    }
}
