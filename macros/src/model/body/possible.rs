//! The triangle inequality of moments of inertia, in every frame.

use crate::model::words::{AXES, shown};
use crate::symbolic::Number;

/// A symmetric matrix, by rows.
pub type Matrix = [[Number; 3]; 3];

/// A matrix from its entries, by rows.
pub fn matrix(numbers: &[Number]) -> Matrix {
    core::array::from_fn(|i| core::array::from_fn(|j| numbers[3 * i + j].clone()))
}

/// An entry of half the trace minus a tensor, which is `int r r dm`.
fn second_moment(j: &Matrix, i: usize, k: usize) -> Number {
    if i != k {
        return -j[i][k].clone();
    }
    let trace = j[0][0].clone() + j[1][1].clone() + j[2][2].clone();
    Number::ratio(1, 2) * trace - j[i][i].clone()
}

/// Whether all mass of a body is in one plane.
pub fn is_flat(j: &Matrix) -> bool {
    determinant(&|i, k| second_moment(j, i, k)).is_zero()
}

/// For a possible tensor, the smallest principal moment divided by the largest, provided that this
/// is small: then the other two are equal, each half of the trace.
pub fn least_moment(j: &Matrix) -> Number {
    let half = Number::ratio(1, 2);
    let largest = half * (j[0][0].clone() + j[1][1].clone() + j[2][2].clone());
    let product = determinant(&|i, k| j[i][k].clone());
    product / (largest.clone() * largest.clone() * largest)
}

/// The ratio of moments of inertia below which a body counts as a rod: of the 16 digits of a moment
/// about its axis, fewer than 7 remain.
pub fn thinnest() -> Number {
    Number::power_of_ten(-9)
}

/// A ratio of moments of inertia that doubles cannot distinguish from zero: twice the one that
/// `new` rejects.
pub fn vanishing() -> Number {
    Number::ratio(1, 1 << 47)
}

pub fn determinant(m: &impl Fn(usize, usize) -> Number) -> Number {
    let minor = |i: usize, k: usize| m(1, i) * m(2, k) - m(1, k) * m(2, i);
    m(0, 0) * minor(1, 2) - m(0, 1) * minor(0, 2) + m(0, 2) * minor(0, 1)
}

/// Whether rounded entries are still those of a body that can rotate about every axis, or of one that
/// swings, which may be a point mass or a rod. They are in the order xx, yy, zz, xy, yz, zx, or the
/// single moment of a planar body.
pub fn is_possible(entries: &[f64], swings: bool) -> bool {
    let [xx, yy, zz, xy, yz, zx] = *entries else {
        let mut moments = entries.iter();
        return moments.all(|moment| *moment > 0.0 || swings && *moment == 0.0);
    };
    // increasing the diagonal relaxes the triangle inequality in every frame
    let slack = SLACK * f64::EPSILON * (xx + yy + zz);
    let rows = |slack: f64| {
        let rows = [
            [xx + slack, xy, zx],
            [xy, yy + slack, yz],
            [zx, yz, zz + slack],
        ];
        rows.map(|row| row.map(Number::from_f64))
    };
    if swings {
        return Violation::unbalanced(&rows(slack)).is_none();
    }
    let turns = determinant(&|i, k| rows(0.0)[i][k].clone()).is_positive();
    turns && Violation::find(&rows(slack)).is_none()
}

/// The slack of this check, in ulp of the trace. It covers that of the runtime, which is 4 ulp of the
/// largest moment, or 16 ulp if there are products.
const SLACK: f64 = 16.0;

/// A condition that a matrix violates, and the entry that is wrong, if it is a single one.
pub struct Violation {
    pub entry: Option<(usize, usize)>,
    pub message: String,
}

impl Violation {
    /// The first violated condition, from the simplest to the most general. The last condition is
    /// that no moment gets lost in the rounding errors of the others.
    pub fn find(j: &Matrix) -> Option<Self> {
        let lost = || {
            (least_moment(j) <= vanishing()).then(|| Self {
                entry: None,
                message: "turned to its principal axes, one moment vanishes beside the others in \
                          the digits of `f64`"
                    .to_owned(),
            })
        };
        Self::impossible(j).or_else(lost)
    }

    /// The first violated condition among those that every body meets.
    pub fn impossible(j: &Matrix) -> Option<Self> {
        for (i, axis) in AXES.iter().enumerate() {
            if !j[i][i].is_positive() {
                let value = shown(&j[i][i]);
                return Some(Self {
                    entry: Some((i, i)),
                    message: format!(
                        "its moment about {axis} is {value}, and moments of inertia are positive"
                    ),
                });
            }
        }
        let singular = || {
            let is_singular = !determinant(&|i, k| j[i][k].clone()).is_positive();
            is_singular
                .then(|| Self::whole("turned to its principal axes, one moment is not positive"))
        };
        Self::unbalanced(j).or_else(singular)
    }

    fn whole(message: &str) -> Self {
        Self {
            entry: None,
            message: message.to_owned(),
        }
    }

    /// The first violated condition among those that also point masses and rods meet: the second
    /// moments of a distribution of mass are not negative.
    pub fn unbalanced(j: &Matrix) -> Option<Self> {
        let sigma = |i: usize, k: usize| second_moment(j, i, k);
        for (i, axis) in AXES.iter().enumerate() {
            let (k, l) = ((i + 1) % 3, (i + 2) % 3);
            if sigma(i, i).is_negative() {
                let (largest, sum) = (shown(&j[i][i]), shown(&(j[k][k].clone() + j[l][l].clone())));
                let message = format!(
                    "its moment about {axis} is larger than the other two together \
                     ({largest} > {sum})"
                );
                return Some(Self {
                    entry: Some((i, i)),
                    message,
                });
            }
        }
        for (i, k) in [(0, 1), (1, 2), (2, 0)] {
            if (sigma(i, i) * sigma(k, k) - sigma(i, k) * sigma(i, k)).is_negative() {
                let message = format!(
                    "the product of inertia in {}{} is too large for its moments of inertia",
                    AXES[i], AXES[k]
                );
                return Some(Self {
                    entry: Some((i, k)),
                    message,
                });
            }
        }
        determinant(&sigma).is_negative().then(|| {
            Self::whole(
                "turned to its principal axes, one moment is larger than the other two together",
            )
        })
    }
}
