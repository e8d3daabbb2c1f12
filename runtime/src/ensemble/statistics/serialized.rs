//! Serialized moments: exact, so that shards can be merged elsewhere.

use alloc::vec::Vec;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

use super::digits::Digits;
use super::{Moments, Statistics};
use crate::bodies::columns::Columns;

#[derive(Serialize, Deserialize)]
#[serde(rename = "Moments", expecting = "the moments of numbers")]
struct Written {
    count: u64,
    not_finite: u64,
    extremes: Option<[f64; 2]>,
    sum: Sparse,
    squares: Sparse,
}

/// Digits without leading and trailing zeros.
#[derive(Serialize, Deserialize)]
#[serde(expecting = "a sum: its digits, and the place of the first")]
struct Sparse {
    first: usize,
    digits: Vec<i64>,
}

impl Sparse {
    fn of<const N: usize>(sum: &Digits<N>) -> Self {
        let list = sum.to_list();
        let is_there = |digit: &i64| *digit != 0;
        let first = list.iter().position(is_there).unwrap_or(0);
        let end = list.iter().rposition(is_there).map_or(0, |last| last + 1);
        Self {
            first,
            digits: list[first.min(end)..end].to_vec(),
        }
    }

    fn sum<const N: usize>(&self) -> Option<Digits<N>> {
        let mut list = [0; N];
        let end = self.first.checked_add(self.digits.len())?;
        list.get_mut(self.first..end)?.copy_from_slice(&self.digits);
        Digits::from_list(&list)
    }
}

impl Serialize for Moments {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let written = Written {
            count: self.count,
            not_finite: self.not_finite,
            extremes: self.extremes,
            sum: Sparse::of(&self.sum),
            squares: Sparse::of(&self.squares),
        };
        written.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Moments {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let written = Written::deserialize(deserializer)?;
        let (sum, squares) = (written.sum.sum(), written.squares.sum());
        let (Some(sum), Some(squares)) = (sum, squares) else {
            return Err(D::Error::custom(
                "the digits of these sums are out of range",
            ));
        };
        let moments = Self {
            count: written.count,
            not_finite: written.not_finite,
            extremes: written.extremes,
            sum,
            squares,
        };
        if moments.is_possible() {
            Ok(moments)
        } else {
            Err(D::Error::custom("no numbers have these moments"))
        }
    }
}

impl<C> Serialize for Statistics<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.columns.serialize(serializer)
    }
}

impl<'de, C: Columns<f64>> Deserialize<'de> for Statistics<C> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let columns = Vec::<Moments>::deserialize(deserializer)?;
        if columns.len() != C::COUNT {
            return Err(D::Error::custom(format_args!(
                "expected the moments of {} columns, and there are {}",
                C::COUNT,
                columns.len()
            )));
        }
        Ok(Self {
            columns,
            kind: core::marker::PhantomData,
        })
    }
}
