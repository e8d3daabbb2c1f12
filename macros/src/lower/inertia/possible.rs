//! Which inertias are possible, and suggestions for a misplaced decimal point.
//!
//! A tensor is possible if it is symmetric and if half its trace minus the tensor is positive
//! semidefinite: this is the triangle inequality in every frame (`docs/statements.md`, F08).
//! Numbers are checked exactly. Equality, which means a flat body, is allowed.

use proc_macro2::Ident;

use crate::errors::Extent;
use crate::lower::expressions::Lowering;
use crate::model::{
    AXES, Composed, Defaults, Inertia, Matrix, Orientation, Violation, least_moment, matrix, shown,
    thinnest,
};
use crate::symbolic::{Id, Number};

use super::draft::Draft;

impl Lowering<'_> {
    /// Checks an inertia as far as it is known.
    pub fn check_inertia(&mut self, draft: &Draft, defaults: &Defaults) -> Option<()> {
        let entries = draft.inertia.entries();
        let written = draft.entries.iter().map(|entry| entry.value);
        let all: Vec<Id> = entries.iter().copied().chain(written).collect();
        let numbers = self.all_known(&all, defaults);
        let Some(numbers) = numbers else {
            // it depends on values that are given when a body is built, so `new` checks it
            return self.check_known_moments(draft);
        };
        match draft.inertia {
            Inertia::Absent => Some(()),
            Inertia::Scalar(_) if numbers[0].is_positive() => Some(()),
            // a point mass may swing about a pin at a distance
            Inertia::Scalar(_) if numbers[0].is_zero() && self.state.swings => Some(()),
            Inertia::Scalar(_) if numbers[0].is_zero() => self.report_zero(draft.extent),
            Inertia::Scalar(_) => self.report(
                draft.extent,
                format!(
                    "the inertia of a body that turns is positive, and J_G = {}",
                    shown(&numbers[0])
                ),
            ),
            Inertia::Spatial(_) => {
                let matrix = matrix(&numbers);
                match self.violation(&matrix) {
                    None => Some(()),
                    Some(_) if matrix.iter().flatten().all(Number::is_zero) => {
                        self.report_zero(draft.extent)
                    }
                    Some(violation) => {
                        self.report_violation(draft, &violation, &matrix, &numbers[9..])
                    }
                }
            }
        }
    }

    /// Reports an inertia that is zero.
    pub fn report_zero<T>(&mut self, place: Extent) -> Option<T> {
        let turns = !self.work.graph.is_zero_vector(&self.state.angular_velocity);
        let message = if !turns || !self.motion.has_attitude() {
            "a body that does not turn needs no inertia: leave `inertia` out"
        } else if self.state.swings {
            "a point mass in space has the inertia `principal(0, 0, 0)[kg * m ^ 2]`"
        } else {
            "a point mass has no inertia about axes through its G: hold it by a hinge beside its G, \
             on the ground or on a body with mass, or give it an inertia"
        };
        self.report(place, message)
    }

    /// Whether a body that is held at a point has an inertia about all axes through this point,
    /// although not about all through its G: its mass lies on a line beside the point.
    pub fn turns_beside(&mut self, inertia: Inertia, mass: Id, defaults: &Defaults) -> bool {
        let is_point = self.motion.orientation == Orientation::Quaternion;
        let Some(support) = self.state.support.filter(|_| is_point) else {
            return false;
        };
        let graph = &mut self.work.graph;
        let about_support = inertia.displaced(graph, mass, support.offset);
        let [own, held] = [inertia, about_support].map(|inertia| {
            let numbers = self.all_known(&inertia.entries(), defaults);
            numbers
                .filter(|numbers| numbers.len() == 9)
                .map(|numbers| matrix(&numbers))
        });
        let (Some(own), Some(held)) = (own, held) else {
            return false;
        };
        let turns = Violation::unbalanced(&own).is_none() && Violation::find(&held).is_none();
        self.state.swings |= turns;
        turns
    }

    /// What makes an inertia impossible for a body that moves like this one.
    fn violation(&self, matrix: &Matrix) -> Option<Violation> {
        if self.state.swings {
            Violation::unbalanced(matrix)
        } else {
            Violation::find(matrix)
        }
    }

    /// Reports a body that rotates freely and is so thin that its rotation about its own axis has
    /// few correct digits (H1), although its inertia is possible. If the inertia depends on
    /// parameters, `new` checks it.
    pub fn check_not_a_rod(&mut self, inertia: Inertia, place: Extent) -> Option<()> {
        let is_held = self.motion.is_supported() || self.state.swings;
        if self.motion.orientation != Orientation::Quaternion || is_held {
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
        let (least, under) = (least.to_f64(), self.under());
        self.report(
            place,
            format!(
                "this body is nearly a rod: its least moment of inertia is {least:.0e} of the largest, \
                 and {under} it could turn about that axis, with less than 7 \
                 correct digits; make it thicker, or write `motion: rod(axis)`"
            ),
        )
    }

    /// Checks that each known moment is positive, whatever the other entries are.
    fn check_known_moments(&mut self, draft: &Draft) -> Option<()> {
        for entry in draft
            .entries
            .iter()
            .filter(|entry| entry.row == entry.column)
        {
            let known = self.work.graph.as_number(entry.value);
            let is_point =
                |moment: &Number| moment.is_zero() && (self.state.swings || self.motion.is_line());
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

    /// Checks a composed inertia. Each part is possible. So without holes, only one thing can be
    /// wrong: all mass lies on one line.
    pub fn check_composed(
        &mut self,
        composed: Composed,
        word: &Ident,
        defaults: &Defaults,
    ) -> Option<()> {
        let inertia = composed.inertia;
        self.check_not_a_rod(inertia, Extent::of(word))?;
        let Some(numbers) = self.all_known(&inertia.entries(), defaults) else {
            return Some(());
        };
        let violated = match (inertia, numbers.as_slice()) {
            (Inertia::Scalar(_), [moment]) if self.state.swings && moment.is_zero() => {
                return Some(());
            }
            (Inertia::Scalar(_), [moment]) if !moment.is_positive() => {
                let axis = if self.motion.is_planar {
                    "the normal of the plane"
                } else {
                    "every axis across the rod"
                };
                format!("about {axis} it is {}", shown(moment))
            }
            (Inertia::Spatial(_), numbers) => match self.violation(&matrix(numbers)) {
                Some(_) if self.turns_beside(inertia, composed.mass, defaults) => return Some(()),
                Some(violation) => violation.message,
                None => return Some(()),
            },
            _ => return Some(()),
        };
        let under = self.under();
        self.report(
            word.span(),
            if composed.has_holes {
                format!(
                    "no body has the inertia of these parts: {violated}; is a hole larger than \
                     what it is in?"
                )
            } else if self.motion.has_one_moment() {
                format!(
                    "all mass of this body is at one point, and {under} it could \
                     turn about it: give a part some extent"
                )
            } else {
                format!(
                    "all mass of this body lies on one line, and {under} it could \
                     turn about it: give a part some extent"
                )
            },
        )
    }

    /// Reports an impossible inertia; `values` are those of its written entries, in SI units.
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
                     `{digits}` would be possible"
                ),
            );
        }
        let blamed = violation
            .entry
            .and_then(|(row, column)| draft.entry(row, column));
        self.report(blamed.map_or(draft.extent, |entry| entry.extent), message)
    }
}

/// A literal written for an entry, and its value in SI units.
struct Literal<'a> {
    row: usize,
    column: usize,
    written: &'a Number,
    value: &'a Number,
}

/// The literal whose shifted decimal point gives a possible inertia, if there is exactly one: its
/// row and column, and the corrected text.
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
