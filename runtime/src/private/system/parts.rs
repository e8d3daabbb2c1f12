//! The lists of a system, joint by joint: the first halves of all lists precede the second
//! halves.

use core::slice;

use crate::bodies::columns::{Named, Names};
use crate::numbers::scalar::Scalar;
use crate::state::Coordinates;

/// The number of coordinates of a state that are not rates.
#[must_use]
pub const fn positions<S: Coordinates>() -> usize {
    sum(S::GROUPS.split_at(S::GROUPS.len() / 2).0)
}

/// The number of its rates.
#[must_use]
pub const fn freedoms<S: Coordinates>() -> usize {
    sum(S::GROUPS.split_at(S::GROUPS.len() / 2).1)
}

/// The number of entries of a displacement that precede those of the rates.
#[must_use]
pub const fn shifts<S: Coordinates>() -> usize {
    if positions::<S>() == 0 {
        0
    } else {
        freedoms::<S>()
    }
}

/// The number of coordinates of a state.
#[must_use]
pub const fn coordinates<S: Coordinates>() -> usize {
    sum(S::GROUPS)
}

/// The unit of the accelerations of a state whose rates have one unit.
#[must_use]
pub const fn second_unit<S: Named>() -> &'static str {
    match last_unit(S::NAMES).as_bytes() {
        b"m/s" => "m/s²",
        b"rad/s" => "rad/s²",
        _ => "",
    }
}

/// The unit of the last column.
const fn last_unit(names: Names) -> &'static str {
    match names {
        Names::Number(unit) | Names::Vector(_, unit) => unit,
        Names::Parts([.., (_, last)]) => last_unit(*last),
        Names::Parts([]) => "",
    }
}

const fn sum(mut groups: &[usize]) -> usize {
    let mut sum = 0;
    while let [first, rest @ ..] = groups {
        sum += *first;
        groups = rest;
    }
    sum
}

/// The number of groups of several states.
#[must_use]
pub const fn count(mut parts: &[&[usize]]) -> usize {
    let mut count = 0;
    while let [first, rest @ ..] = parts {
        count += first.len();
        parts = rest;
    }
    count
}

/// The groups of a system, from those of its joints.
#[must_use]
pub const fn groups<const N: usize>(parts: &[&[usize]]) -> [usize; N] {
    let (mut groups, mut place, mut half) = ([0; N], 0, 0);
    while half < 2 {
        let mut left = parts;
        while let [part, rest @ ..] = left {
            let (positions, rates) = part.split_at(part.len() / 2);
            let mut left_of_part = if half == 0 { positions } else { rates };
            while let [group, rest @ ..] = left_of_part {
                groups[place] = *group;
                place += 1;
                left_of_part = rest;
            }
            left = rest;
        }
        half += 1;
    }
    groups
}

/// The places of attitude and angular velocity of the only joint that has axes, from the groups and
/// the places of each joint.
#[must_use]
pub const fn axes(parts: &[(&[usize], Option<[usize; 2]>)]) -> Option<[usize; 2]> {
    let (mut found, mut left) = (None, parts);
    let (mut attitudes, mut rates) = (0, 0);
    while let [(groups, axes), rest @ ..] = left {
        let (first, second) = groups.split_at(groups.len() / 2);
        if let Some([attitude, rate]) = *axes {
            if found.is_some() {
                return None;
            }
            found = Some([attitudes + attitude, rates + rate - sum(first)]);
        }
        attitudes += sum(first);
        rates += sum(second);
        left = rest;
    }
    match found {
        Some([attitude, rate]) => Some([attitude, attitudes + rate]),
        None => None,
    }
}

/// Any number of a state, to start a list from: a number cannot be made from nothing.
#[cfg_attr(not(unoptimized), inline(always))]
#[must_use]
pub fn any<S: Coordinates>(state: &S) -> S::Scalar {
    let list = state.coordinates();
    list.as_ref().first().copied().unwrap_or_default()
}

/// A list that is read joint by joint.
#[derive(Debug)]
pub struct Parts<'a, T> {
    first: slice::Iter<'a, T>,
    second: slice::Iter<'a, T>,
    /// The value beyond the end.
    any: T,
}

impl<'a, T: Scalar> Parts<'a, T> {
    /// A list whose first half has this many numbers.
    #[cfg_attr(not(unoptimized), inline(always))]
    #[must_use]
    pub fn of(list: &'a impl AsRef<[T]>, place: usize, any: T) -> Self {
        let list = list.as_ref();
        let (first, second) = list.split_at_checked(place).unwrap_or_default();
        Self {
            first: first.iter(),
            second: second.iter(),
            any,
        }
    }

    /// The part of the next joint, with this many numbers in the first half.
    #[cfg_attr(not(unoptimized), inline(always))]
    #[must_use]
    pub fn take<const N: usize>(&mut self, first: usize) -> [T; N] {
        core::array::from_fn(|k| {
            let half = if k < first {
                &mut self.first
            } else {
                &mut self.second
            };
            half.next().copied().unwrap_or(self.any)
        })
    }
}

/// A list that is written joint by joint.
#[derive(Debug)]
pub struct PartsMut<'a, T> {
    first: slice::IterMut<'a, T>,
    second: slice::IterMut<'a, T>,
}

impl<'a, T: Scalar> PartsMut<'a, T> {
    /// A list whose first half has this many numbers.
    #[cfg_attr(not(unoptimized), inline(always))]
    #[must_use]
    pub fn of(list: &'a mut impl AsMut<[T]>, place: usize) -> Self {
        let list = list.as_mut();
        let (first, second) = list.split_at_mut_checked(place).unwrap_or_default();
        Self {
            first: first.iter_mut(),
            second: second.iter_mut(),
        }
    }

    /// The part of the next joint, with this many numbers in the first half.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub fn put(&mut self, part: &[T], first: usize) {
        for (k, number) in part.iter().enumerate() {
            let half = if k < first {
                &mut self.first
            } else {
                &mut self.second
            };
            if let Some(place) = half.next() {
                *place = *number;
            }
        }
    }
}
