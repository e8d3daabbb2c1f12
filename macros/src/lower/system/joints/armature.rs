//! Inertia along the coordinate of a joint only, such as that of a geared rotor: `.armature(J)`.

use crate::errors::Errors;
use crate::lower::expressions::Lowering;
use crate::lower::system::reading::reader::Reader;
use crate::model::{Dimension, JointKind, Part};
use crate::symbolic::{Id, Number};
use crate::syntax::{Called, Expression};

const WHAT: &str = "the armature of a joint";

impl Reader<'_> {
    /// The argument of `.armature(J)`. The inner `None` means that it is not written.
    #[allow(clippy::option_option, reason = "outer: reported; inner: not written")]
    pub fn armature(
        &mut self,
        kind: &JointKind,
        methods: &[Called<'_>],
        errors: &mut Errors,
    ) -> Option<Option<Id>> {
        let mut written = methods.iter().filter(|(method, _)| *method == "armature");
        let Some((word, arguments)) = written.next() else {
            return Some(None);
        };
        if let Some((again, _)) = written.next() {
            errors.push(again.span(), "`.armature(..)` is written twice");
            return None;
        }
        let dimension = match kind.parts {
            [Part::Turn(_) | Part::Screw] => Dimension::INERTIA,
            [Part::Slide(_)] => Dimension::MASS,
            _ => {
                let message = format!(
                    "an armature is along one coordinate, and `{}` has none or several",
                    kind.word
                );
                errors.push(word.span(), message);
                return None;
            }
        };
        let [value] = arguments else {
            let message = "write `.armature(J)` with an inertia, kg m^2 for what turns and kg for what slides";
            errors.push(word.span(), message);
            return None;
        };
        self.at_top(errors, |lowering| constant(lowering, value, dimension))
            .map(Some)
    }
}

fn constant(lowering: &mut Lowering<'_>, written: &Expression, dimension: Dimension) -> Option<Id> {
    let value = lowering.scalar(written, dimension, WHAT)?;
    lowering.check_early(written, &[value], &format!("{WHAT} is fixed"))?;
    let is_negative = |number: &Number| !number.is_zero() && !number.is_positive();
    if lowering
        .work
        .graph
        .as_number(value)
        .is_some_and(is_negative)
    {
        return lowering.report(written.extent, format!("{WHAT} is not negative"));
    }
    Some(value)
}
