//! The series of one body, by the best instructions of the processor, detected once per motion.

#[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
use pulp::x86::{V3, V4};
#[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
use pulp::{Simd, WithSimd};

use super::agreement::Agreement;
use super::equations::Rates;
use super::point::Point;
use crate::state::Coordinates;
#[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
use crate::taylor::Arithmetic;
use crate::taylor::{Plain, Series, Taylor};

/// The workspace of expansions.
pub(in crate::integrate) enum Expander<B: Taylor, const N: usize> {
    /// With the baseline instructions of the target.
    Plain(B::Products<Plain, N>),
    /// With AVX2 and fused operations, and the proof of them.
    #[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
    Wide(V3, B::Products<V3, N>),
    /// With AVX-512.
    #[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
    Widest(V4, B::Products<V4, N>),
}

impl<B: Taylor, const N: usize> Expander<B, N> {
    /// With the best available instructions.
    pub(in crate::integrate) fn best() -> Self {
        #[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
        {
            if let Some(proof) = V4::try_new() {
                return Self::Widest(proof, proof.into());
            }
            if let Some(proof) = V3::try_new() {
                return Self::Wide(proof, proof.into());
            }
        }
        Self::Plain(Plain.into())
    }

    /// Like [`Taylor::expand`].
    #[inline]
    pub(in crate::integrate) fn expand(
        &mut self,
        body: &B,
        time: f64,
        state: &B::State,
        input: &B::Input,
        series: &mut Series<B::State, N>,
    ) {
        match self {
            Self::Plain(products) => body.expand(time, state, input, products, series),
            #[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
            Self::Wide(proof, products) => {
                let start = (body, time, state, input);
                Simd::vectorize(*proof, Expansion::<B, V3, N>(start, products, series));
            }
            #[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
            Self::Widest(proof, products) => {
                let start = (body, time, state, input);
                Simd::vectorize(*proof, Expansion::<B, V4, N>(start, products, series));
            }
        }
    }
}

impl<B: Taylor, const N: usize> Expander<B, N> {
    /// Like [`Agreement::holds`].
    #[inline]
    pub(in crate::integrate) fn holds<E: Rates<State = B::State>>(
        &self,
        agreement: &Agreement<'_, E, N>,
        now: &Point<B::State>,
        step: f64,
    ) -> Option<<B::State as Coordinates>::Array> {
        self.look(Look(
            #[cfg_attr(not(unoptimized), inline(always))]
            || agreement.holds(now, step),
        ))
    }

    /// Like [`Agreement::holds_throughout`].
    #[cold]
    pub(in crate::integrate) fn holds_throughout<E: Rates<State = B::State>>(
        &self,
        agreement: &Agreement<'_, E, N>,
        now: &Point<B::State>,
        step: f64,
    ) -> Result<<B::State as Coordinates>::Array, f64> {
        self.look(Look(
            #[cfg_attr(not(unoptimized), inline(always))]
            || agreement.holds_throughout(now, step),
        ))
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn look<R>(&self, Look(look): Look<impl FnOnce() -> R>) -> R {
        match self {
            Self::Plain(_) => look(),
            #[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
            Self::Wide(proof, _) => Simd::vectorize(*proof, Look(look)),
            #[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
            Self::Widest(proof, _) => Simd::vectorize(*proof, Look(look)),
        }
    }
}

/// The work of one check of a step, in a function that is compiled for the instructions.
struct Look<F>(F);

#[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
impl<R, F: FnOnce() -> R> WithSimd for Look<F> {
    type Output = R;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn with_simd<S: Simd>(self, _: S) -> R {
        (self.0)()
    }
}

/// The work of one expansion from a state, in a function that is compiled for the instructions.
#[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
struct Expansion<'e, B: Taylor, A: Arithmetic, const N: usize>(
    (&'e B, f64, &'e B::State, &'e B::Input),
    &'e mut B::Products<A, N>,
    &'e mut Series<B::State, N>,
);

#[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
impl<B: Taylor, A: Arithmetic, const N: usize> WithSimd for Expansion<'_, B, A, N> {
    type Output = ();

    #[cfg_attr(not(unoptimized), inline(always))]
    fn with_simd<S: Simd>(self, _: S) {
        let Self((body, time, state, input), products, series) = self;
        body.expand(time, state, input, products, series);
    }
}
