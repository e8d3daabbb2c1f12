//! Columns of numbers, in blocks of eight members.

use alloc::vec::Vec;
use core::marker::PhantomData;
use core::ops::Range;

use crate::bodies::columns::{Columns, Sink, Source};
use crate::numbers::lanes::{Lanes, Register};

/// The number of members of a block: one cache line per number.
pub(super) const BLOCK: usize = 8;

/// One number of each member of a block.
pub(super) type Eight = [f64; BLOCK];

/// A list of values, kept as columns of their scalars.
///
/// The columns are cut into blocks of eight values, stored one after another. A block is therefore
/// contiguous in memory, however many columns there are.
///
/// ```
/// use newton_euler::nalgebra::Vector3;
/// use newton_euler::ensemble::Blocks;
///
/// let mut list: Blocks<Vector3<f64>> = (0..20_u8).map(|i| Vector3::x() * f64::from(i)).collect();
/// list.set(7, &Vector3::z());
/// assert_eq!((list.len(), list.get(7), list.get(19).x), (20, Vector3::z(), 19.0));
///
/// list.update(|index, value| value.y = if index < 10 { 0.5 } else { 0.0 });
/// let mut sum = 0.0;
/// for value in &list {
///     sum += value.y;
/// }
/// assert_eq!(sum, 5.0);
/// ```
#[derive(Clone, Debug)]
pub struct Blocks<C> {
    /// As many rows as there are columns, for the first block, then for the second, and so on. The
    /// last block is padded with earlier values of the list: they are computed, but never
    /// read.
    rows: Vec<Eight>,
    len: usize,
    kind: PhantomData<C>,
}

impl<C: Columns<f64>> Blocks<C> {
    /// The same value many times.
    #[must_use]
    pub fn repeat(value: &C, len: usize) -> Self {
        let mut rows = alloc::vec![[0.0; BLOCK]; C::COUNT * len.div_ceil(BLOCK)];
        for block in 0..len.div_ceil(BLOCK) {
            for lane in 0..BLOCK {
                write(&mut rows, block, lane, value);
            }
        }
        Self {
            rows,
            len,
            kind: PhantomData,
        }
    }

    /// The number of values.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The value at an index.
    ///
    /// # Panics
    /// If the index is out of range.
    #[must_use]
    pub fn get(&self, index: usize) -> C {
        self.check(index);
        C::read(&mut Column {
            rows: &self.rows[range::<C>(index / BLOCK)],
            lane: index % BLOCK,
        })
    }

    /// Replaces a value.
    ///
    /// # Panics
    /// If the index is out of range.
    pub fn set(&mut self, index: usize, value: &C) {
        self.check(index);
        write(&mut self.rows, index / BLOCK, index % BLOCK, value);
    }

    /// All values in order, as copies: they are stored as columns.
    #[must_use]
    pub fn iter(&self) -> Values<'_, C> {
        Values {
            blocks: self,
            left: 0..self.len,
        }
    }

    /// Changes each value, given with its index, in order.
    pub fn update(&mut self, mut change: impl FnMut(usize, &mut C)) {
        for index in 0..self.len {
            let mut value = self.get(index);
            change(index, &mut value);
            self.set(index, &value);
        }
    }

    /// Zeros for as many members.
    pub(super) fn zeros_like<D: Columns<f64>>(&self) -> Blocks<D> {
        Blocks {
            rows: alloc::vec![[0.0; BLOCK]; D::COUNT * self.len.div_ceil(BLOCK)],
            len: self.len,
            kind: PhantomData,
        }
    }

    /// The rows of a block, if there is one.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn block(&self, index: usize) -> Option<&[Eight]> {
        self.rows.get(range::<C>(index))
    }

    pub(super) fn rows_mut(&mut self) -> &mut [Eight] {
        &mut self.rows
    }

    /// Whether each value has an infinite number or NaN.
    pub(super) fn lost(&self) -> Vec<bool> {
        let blocks = self.rows.chunks(C::COUNT.max(1));
        let lost = blocks.flat_map(|rows| zeros(rows).map(|zero| zero != 0.0));
        lost.take(self.len).collect()
    }

    fn check(&self, index: usize) {
        assert!(
            index < self.len,
            "there are {} members, and no member {index}",
            self.len
        );
    }
}

/// The values of [`Blocks`] in order.
#[derive(Clone, Debug)]
pub struct Values<'b, C> {
    blocks: &'b Blocks<C>,
    left: Range<usize>,
}

impl<C: Columns<f64>> Iterator for Values<'_, C> {
    type Item = C;

    fn next(&mut self) -> Option<C> {
        self.left.next().map(|index| self.blocks.get(index))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.left.size_hint()
    }
}

impl<C: Columns<f64>> DoubleEndedIterator for Values<'_, C> {
    fn next_back(&mut self) -> Option<C> {
        self.left.next_back().map(|index| self.blocks.get(index))
    }
}

impl<C: Columns<f64>> ExactSizeIterator for Values<'_, C> {}

impl<'b, C: Columns<f64>> IntoIterator for &'b Blocks<C> {
    type Item = C;
    type IntoIter = Values<'b, C>;

    fn into_iter(self) -> Values<'b, C> {
        self.iter()
    }
}

/// Equal values in the same order.
impl<C: Columns<f64>> PartialEq for Blocks<C> {
    fn eq(&self, other: &Self) -> bool {
        let rows = || self.rows.iter().zip(&other.rows).enumerate();
        self.len == other.len
            && rows().all(|(index, (row, other))| {
                let members = self.len - index / C::COUNT * BLOCK;
                let there = ..members.min(BLOCK);
                row[there] == other[there]
            })
    }
}

impl<C: Columns<f64>> FromIterator<C> for Blocks<C> {
    fn from_iter<I: IntoIterator<Item = C>>(values: I) -> Self {
        let mut blocks = Self {
            rows: Vec::new(),
            len: 0,
            kind: PhantomData,
        };
        for value in values {
            let (block, lane) = (blocks.len / BLOCK, blocks.len % BLOCK);
            if lane == 0 {
                blocks.rows.resize(C::COUNT * (block + 1), [0.0; BLOCK]);
                for rest in 1..BLOCK {
                    write(&mut blocks.rows, block, rest, &value);
                }
            }
            write(&mut blocks.rows, block, lane, &value);
            blocks.len += 1;
        }
        blocks
    }
}

/// For each lane zero, or NaN if one of its numbers is infinite or NaN.
fn zeros(rows: &[Eight]) -> Eight {
    rows.iter().fold([0.0; BLOCK], |mut sums, row| {
        for (sum, number) in sums.iter_mut().zip(row) {
            *sum += 0.0 * number;
        }
        sums
    })
}

/// The rows of a block.
#[cfg_attr(not(unoptimized), inline(always))]
pub(super) fn range<C: Columns<f64>>(block: usize) -> Range<usize> {
    C::COUNT * block..C::COUNT * (block + 1)
}

pub(super) fn write<C: Columns<f64>>(rows: &mut [Eight], block: usize, lane: usize, value: &C) {
    value.write(&mut ColumnMut {
        rows: rows[range::<C>(block)].iter_mut(),
        lane,
    });
}

/// One member of a block.
struct Column<'a> {
    rows: &'a [Eight],
    lane: usize,
}

impl Source<f64> for Column<'_> {
    fn take(&mut self) -> f64 {
        let (row, rest) = self.rows.split_first().expect("a row for each scalar");
        self.rows = rest;
        row[self.lane]
    }
}

/// One member of a block, to be written.
struct ColumnMut<'a> {
    rows: core::slice::IterMut<'a, Eight>,
    lane: usize,
}

impl Sink<f64> for ColumnMut<'_> {
    fn put(&mut self, scalar: f64) {
        let row = self.rows.next().expect("a row for each scalar");
        row[self.lane] = scalar;
    }
}

/// As many members of a block as a register holds: the group with this index.
pub(super) struct Group<'a, S> {
    pub(super) simd: S,
    pub(super) rows: &'a [Eight],
    pub(super) index: usize,
}

impl<S: Register> Source<Lanes<S>> for Group<'_, S> {
    #[cfg_attr(not(unoptimized), inline(always))]
    fn take(&mut self) -> Lanes<S> {
        let (row, rest) = self.rows.split_first().expect("a row for each scalar");
        self.rows = rest;
        let (registers, _) = S::as_simd_f64s(row);
        Lanes::new(self.simd, registers[self.index])
    }
}

/// As many members of a block as a register holds, to be written.
pub(super) struct GroupMut<'a> {
    pub(super) rows: core::slice::IterMut<'a, Eight>,
    pub(super) index: usize,
}

impl<S: Register> Sink<Lanes<S>> for GroupMut<'_> {
    #[cfg_attr(not(unoptimized), inline(always))]
    fn put(&mut self, scalar: Lanes<S>) {
        let row = self.rows.next().expect("a row for each scalar");
        let (registers, _) = S::as_mut_simd_f64s(row);
        registers[self.index] = scalar.numbers();
    }
}
