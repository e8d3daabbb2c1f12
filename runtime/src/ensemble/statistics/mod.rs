//! Means, variances and extremes of many values, by exact sums: the same bits in any order.

mod digits;
mod moments;
#[cfg(feature = "serde")]
mod serialized;
mod whole;

use alloc::vec::Vec;
use core::fmt;
use core::marker::PhantomData;
use core::ops::Range;

pub use moments::Moments;

use super::Ensemble;
use crate::bodies::columns::{Columns, Generic, Sink};

/// The moments of each column of some values.
///
/// Sums are exact until a result is requested. The bits of a mean therefore depend neither on how
/// the values are divided among shards, processes and threads, nor on the order in which they are
/// merged.
///
/// ```
/// use newton_euler::ensemble::Statistics;
/// use newton_euler::nalgebra::Vector2;
///
/// let value = |i: u32| Vector2::new(1.0 / f64::from(i + 1), 1e16 * f64::from(i % 3) - 1e16);
/// let all: Statistics<_> = (0..999).map(value).collect();
/// let mut parts: Statistics<_> = (500..999).map(value).collect();
/// parts.merge(&(0..500).map(value).collect());
/// assert_eq!(parts, all);
///
/// let [x, y] = all.columns() else { unreachable!("two components") };
/// assert_eq!((x.count(), y.mean()), (999, Some(0.0)));
/// ```
pub struct Statistics<C> {
    columns: Vec<Moments>,
    kind: PhantomData<fn() -> C>,
}

impl<C> Clone for Statistics<C> {
    fn clone(&self) -> Self {
        Self {
            columns: self.columns.clone(),
            kind: PhantomData,
        }
    }
}

impl<C> fmt::Debug for Statistics<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(&self.columns).finish()
    }
}

/// The same values, in any order.
impl<C> PartialEq for Statistics<C> {
    fn eq(&self, other: &Self) -> bool {
        self.columns == other.columns
    }
}

impl<C: Columns<f64>> Statistics<C> {
    /// The statistics of no values.
    #[must_use]
    pub fn new() -> Self {
        Self {
            columns: (0..C::COUNT).map(|_| Moments::new()).collect(),
            kind: PhantomData,
        }
    }

    /// Adds a value.
    pub fn add(&mut self, value: &C) {
        value.write(&mut Row {
            columns: self.columns.iter_mut(),
        });
    }

    /// Adds the values of others.
    pub fn merge(&mut self, others: &Self) {
        for (own, other) in self.columns.iter_mut().zip(&others.columns) {
            own.merge(other);
        }
    }

    /// The moments of each column, in the order of [`Columns`], which
    /// [`Named`](crate::columns::Named) names.
    #[must_use]
    pub fn columns(&self) -> &[Moments] {
        &self.columns
    }
}

impl<C: Columns<f64>> Default for Statistics<C> {
    fn default() -> Self {
        Self::new()
    }
}

impl<C: Columns<f64>> Extend<C> for Statistics<C> {
    fn extend<I: IntoIterator<Item = C>>(&mut self, values: I) {
        values.into_iter().for_each(|value| self.add(&value));
    }
}

impl<C: Columns<f64>> FromIterator<C> for Statistics<C> {
    fn from_iter<I: IntoIterator<Item = C>>(values: I) -> Self {
        let mut statistics = Self::new();
        statistics.extend(values);
        statistics
    }
}

/// The number of members that one thread takes at a time.
#[cfg(feature = "rayon")]
const PART: usize = 256;

impl<B: Generic> Ensemble<B> {
    /// Means, variances and extremes of the states of all members.
    ///
    /// ```
    /// use newton_euler::columns::Named as _;
    /// use newton_euler::{ensemble::Ensemble, prelude::*};
    ///
    /// rigid_body!(Stone::<T> {
    ///     motion: planar_translation,
    ///     mass: 2[kg],
    ///     fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    /// });
    ///
    /// let thrown = |i: u32| PlanarTranslation {
    ///     velocity: [f64::from(i), 10.0].into(),
    ///     ..PlanarTranslation::default()
    /// };
    /// let mut stones = Ensemble::new(&Stone::default(), (0..101).map(thrown));
    /// stones.cf4(0.0..2.0, 100);
    /// let statistics = stones.statistics();
    /// let distance = &statistics.columns()[0];
    /// assert!((distance.mean().expect("members") - 100.0).abs() < 1e-12);
    /// assert!(PlanarTranslation::NAMES.to_string().starts_with("position.x,"));
    /// ```
    #[must_use]
    pub fn statistics(&self) -> Statistics<B::State> {
        let of = |members: Range<usize>| -> Statistics<B::State> {
            members.map(|index| self.state(index)).collect()
        };
        #[cfg(not(feature = "rayon"))]
        return of(0..self.len());
        #[cfg(feature = "rayon")]
        {
            use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};
            let parts = (0..self.len().div_ceil(PART)).into_par_iter();
            let parts = parts.map(|part| of(part * PART..self.len().min((part + 1) * PART)));
            parts.reduce(Statistics::new, |mut all, part| {
                all.merge(&part);
                all
            })
        }
    }
}

/// The columns that take the next numbers.
struct Row<'a> {
    columns: core::slice::IterMut<'a, Moments>,
}

impl Sink<f64> for Row<'_> {
    fn put(&mut self, number: f64) {
        if let Some(column) = self.columns.next() {
            column.add(number);
        }
    }
}

/// The members of a shard, as a range. `members` are divided into `shards` whose sizes differ by at
/// most one.
///
/// ```
/// use newton_euler::ensemble::shard;
///
/// let shards: Vec<_> = (0..3).map(|index| shard(10, index, 3)).collect();
/// assert_eq!(shards, [0..3, 3..6, 6..10]);
/// ```
///
/// # Panics
/// If there is no such shard.
#[must_use]
pub fn shard(members: u64, index: u64, shards: u64) -> Range<u64> {
    assert!(
        index < shards,
        "there are {shards} shards, and no shard {index}"
    );
    let first = |index: u64| {
        let first = u128::from(members) * u128::from(index) / u128::from(shards);
        u64::try_from(first).unwrap_or(members)
    };
    first(index)..first(index + 1)
}
