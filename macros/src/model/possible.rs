//! Which inertias a body can have, and the decimal point that one may have lost.
//!
//! A tensor is possible if it is symmetric and half its trace minus itself is positive
//! semidefinite, which is the triangle inequality in every frame (`docs/statements.md`, F08). Numbers are
//! checked exactly; equality, a flat body, is allowed.

use proc_macro2::Ident;

use crate::errors::Extent;
use crate::symbolic::{Id, Number};

use super::draft::Draft;
use super::inertia::Inertia;
use super::lower::Lowering;
use super::motion::Motion;
use super::parameters::Defaults;
use super::value::shown;

impl Lowering<'_> {
    /// Checks an inertia as far as it is known.
    pub fn check_inertia(&mut self, draft: &Draft, defaults: &Defaults) -> Option<()> {
        let entries = draft.inertia.entries();
        let written = draft.entries.iter().map(|entry| entry.value);
        let all: Vec<Id> = entries.iter().copied().chain(written).collect();
        let numbers = self.all_known(&all, defaults);
        let Some(numbers) = numbers else {
            // it depends on what is given when a body is built, and the rest is checked there
            return self.check_known_moments(draft);
        };
        match draft.inertia {
            Inertia::Absent => Some(()),
            Inertia::Scalar(_) if numbers[0].is_positive() => Some(()),
            // a point swings about a pin away from it
            Inertia::Scalar(_) if numbers[0].is_zero() && self.is_held_off_center() => Some(()),
            Inertia::Scalar(_) => self.report(
                draft.extent,
                format!(
                    "the inertia of a body that turns is positive, and J_G = {}",
                    shown(&numbers[0])
                ),
            ),
            Inertia::Spatial(_) => {
                let matrix = matrix(&numbers);
                match Violation::find(&matrix) {
                    None => Some(()),
                    Some(violation) => {
                        self.report_violation(draft, &violation, &matrix, &numbers[9..])
                    }
                }
            }
        }
    }

    /// Refuses a body that turns freely and is so thin that its turning about its own axis has few
    /// correct digits (H1), although a body can have this inertia; what is made from parameters is
    /// left to `new`.
    pub fn check_not_a_rod(&mut self, inertia: Inertia, place: Extent) -> Option<()> {
        if !matches!(self.motion, Motion::Spatial | Motion::Rotation) {
            return Some(());
        }
        let graph = &self.work.graph;
        let entries = inertia.entries();
        let numbers = entries.iter().map(|id| graph.as_number(*id).cloned());
        let Some(numbers) = numbers.collect::<Option<Vec<_>>>() else {
            return Some(());
        };
        let tensor = matrix(&numbers);
        if Violation::impossible(&tensor).is_some() {
            return Some(());
        }
        let least = least_moment(&tensor);
        if least >= thinnest() {
            return Some(());
        }
        let (least, motion) = (least.to_f64(), self.motion.word());
        self.report(
            place,
            format!(
                "this body is all but a rod: its least moment of inertia is {least:.0e} of the largest, \
                 and under `motion: {motion}` it could turn about that axis, with less than 7 \
                 correct digits; make it thicker, or write `motion: rod(axis)`"
            ),
        )
    }

    /// Whether a point other than G is held.
    fn is_held_off_center(&self) -> bool {
        let support = self.state.support;
        support.is_some_and(|support| !self.work.graph.is_zero_vector(&support.offset))
    }

    /// Whatever the rest is: a moment that is known is positive.
    fn check_known_moments(&mut self, draft: &Draft) -> Option<()> {
        for entry in draft
            .entries
            .iter()
            .filter(|entry| entry.row == entry.column)
        {
            let known = self.work.graph.as_number(entry.value);
            let is_point = |moment: &Number| {
                let is_held = self.motion.is_planar() && self.is_held_off_center();
                moment.is_zero() && (is_held || self.motion == Motion::Rod)
            };
            let wrong = |moment: &&Number| !moment.is_positive() && !is_point(moment);
            if let Some(moment) = known.filter(wrong) {
                let (axis, value) = (AXES[entry.row], shown(moment));
                return self.report(
                    entry.extent,
                    format!(
                        "no body has this inertia: its moment about {axis} is {value}, and \
                         moments of inertia are positive"
                    ),
                );
            }
        }
        Some(())
    }

    /// Checks what parts make together. Each of them is possible, so that without holes the worst
    /// that can be is that all mass lies on one line.
    pub fn check_composed(
        &mut self,
        inertia: Inertia,
        has_holes: bool,
        word: &Ident,
        defaults: &Defaults,
    ) -> Option<()> {
        let Some(numbers) = self.all_known(&inertia.entries(), defaults) else {
            return Some(());
        };
        let violated = match (inertia, numbers.as_slice()) {
            (Inertia::Scalar(_), [moment]) if !moment.is_positive() => {
                let axis = if self.motion.is_planar() {
                    "the normal of the plane"
                } else {
                    "every axis across the rod"
                };
                format!("about {axis} it is {}", shown(moment))
            }
            (Inertia::Spatial(_), numbers) => match Violation::find(&matrix(numbers)) {
                Some(violation) => violation.message,
                None => return Some(()),
            },
            _ => return Some(()),
        };
        let motion = self.motion.word();
        self.report(
            word.span(),
            if has_holes {
                format!(
                    "no body has the inertia of these parts: {violated}; is a hole larger than \
                     what it is in?"
                )
            } else if self.motion.has_one_moment() {
                format!(
                    "all mass of this body is at one point, and under `motion: {motion}` it could \
                     turn about it: give a part some extent"
                )
            } else {
                format!(
                    "all mass of this body lies on one line, and under `motion: {motion}` it could \
                     turn about it: give a part some extent"
                )
            },
        )
    }

    /// `values` are those of the entries as they were written, in SI units.
    fn report_violation(
        &mut self,
        draft: &Draft,
        violation: &Violation,
        matrix: &Matrix,
        values: &[Number],
    ) -> Option<()> {
        let message = format!("no body has this inertia: {}", violation.message);
        let literals: Vec<Literal<'_>> = draft
            .entries
            .iter()
            .zip(values)
            .filter_map(|(entry, value)| {
                Some(Literal {
                    row: entry.row,
                    column: entry.column,
                    written: entry.literal.as_ref()?,
                    value,
                })
            })
            .collect();
        if let Some((row, column, mended)) = mend(matrix, &literals)
            && let Some(entry) = draft.entry(row, column)
        {
            let digits = &entry.digits;
            return self.report(
                entry.extent,
                format!(
                    "{message}; is a decimal point out of place? `{mended}` instead of \
                     `{digits}` would do"
                ),
            );
        }
        let blamed = violation
            .entry
            .and_then(|(row, column)| draft.entry(row, column));
        self.report(blamed.map_or(draft.extent, |entry| entry.extent), message)
    }
}

/// A symmetric matrix, by rows.
type Matrix = [[Number; 3]; 3];

/// The first nine numbers.
fn matrix(numbers: &[Number]) -> Matrix {
    core::array::from_fn(|i| core::array::from_fn(|j| numbers[3 * i + j].clone()))
}

/// Names of the axes in messages.
const AXES: [&str; 3] = ["x", "y", "z"];

/// A condition that a matrix violates, and the entry to blame, if it is one.
struct Violation {
    entry: Option<(usize, usize)>,
    message: String,
}

/// A literal that was written for an entry, and what it stands for in SI units.
struct Literal<'a> {
    row: usize,
    column: usize,
    written: &'a Number,
    value: &'a Number,
}

impl Violation {
    /// The first violated condition, from the simplest to the most general; the last is that no
    /// moment is lost beside the others.
    fn find(j: &Matrix) -> Option<Self> {
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

    /// The first condition that no body violates.
    fn impossible(j: &Matrix) -> Option<Self> {
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
        let whole = |message: &str| {
            Some(Self {
                entry: None,
                message: message.to_owned(),
            })
        };
        if determinant(&sigma).is_negative() {
            return whole(
                "turned to its principal axes, one moment is larger than the other two together",
            );
        }
        if !determinant(&|i, k| j[i][k].clone()).is_positive() {
            return whole("turned to its principal axes, one moment is not positive");
        }
        None
    }
}

/// Half the trace minus a tensor, which is `int r r dm`.
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

/// Of a possible tensor, the least principal moment over the largest, where it is small: the others are
/// then equal, half of the trace each.
fn least_moment(j: &Matrix) -> Number {
    let half = Number::ratio(1, 2);
    let largest = half * (j[0][0].clone() + j[1][1].clone() + j[2][2].clone());
    let product = determinant(&|i, k| j[i][k].clone());
    product / (largest.clone() * largest.clone() * largest)
}

/// The ratio of moments of inertia below which a body is a rod: of the 16 digits of a moment about its
/// axis, less than 7 are left.
fn thinnest() -> Number {
    Number::power_of_ten(-9)
}

/// A ratio of moments of inertia that doubles do not tell from zero: twice what `new` refuses.
fn vanishing() -> Number {
    Number::ratio(1, 1 << 47)
}

fn determinant(m: &impl Fn(usize, usize) -> Number) -> Number {
    let minor = |i: usize, k: usize| m(1, i) * m(2, k) - m(1, k) * m(2, i);
    m(0, 0) * minor(1, 2) - m(0, 1) * minor(0, 2) + m(0, 2) * minor(0, 1)
}

/// The one literal, if there is only one, that a moved decimal point turns into one of a possible
/// inertia: its row and column, and what to write.
fn mend(matrix: &Matrix, literals: &[Literal<'_>]) -> Option<(usize, usize, String)> {
    for shift in 1..=3 {
        let mut found = Vec::new();
        for literal in literals {
            for power in [shift, -shift] {
                let factor = Number::power_of_ten(power);
                let added = (factor.clone() - Number::one()) * literal.value.clone();
                let mut mended = matrix.clone();
                let (row, column) = (literal.row, literal.column);
                mended[row][column] = mended[row][column].clone() + added;
                mended[column][row] = mended[row][column].clone();
                if Violation::find(&mended).is_none() {
                    let digits = shown(&(literal.written.clone() * factor));
                    found.push((row, column, digits));
                }
            }
        }
        match found.len() {
            0 => {}
            1 => return found.pop(),
            _ => return None,
        }
    }
    None
}

/// Slack of the runtime's own check, in ulp of the trace.
const SLACK: f64 = 16.0;

/// Whether rounded entries, in the order xx, yy, zz, xy, yz, zx, or the one of a planar body, are
/// still those of a body that can turn about every axis.
pub fn is_possible(entries: &[f64]) -> bool {
    let [xx, yy, zz, xy, yz, zx] = *entries else {
        return entries.iter().all(|moment| *moment > 0.0);
    };
    // more on the diagonal makes room in the triangle inequality of every frame
    let slack = SLACK * f64::EPSILON * (xx + yy + zz);
    let rows = |slack: f64| {
        let rows = [
            [xx + slack, xy, zx],
            [xy, yy + slack, yz],
            [zx, yz, zz + slack],
        ];
        rows.map(|row| row.map(Number::from_f64))
    };
    let turns = determinant(&|i, k| rows(0.0)[i][k].clone()).is_positive();
    turns && Violation::find(&rows(slack)).is_none()
}
