//! Inertia along the coordinate of a joint only, such as that of a geared rotor: `.armature(J)`.

use crate::errors::Errors;
use crate::lower::expressions::Lowering;
use crate::lower::system::reading::reader::Reader;
use crate::model::{Dimension, JointKind, Part, Property, TreeJoint, shown};
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
        let armature = self.at_top(errors, |lowering| constant(lowering, value, dimension))?;
        let known = self.with_defaults(armature);
        if let Some(number) = known.filter(is_negative) {
            let number = shown(&number);
            let message = format!(
                "with the defaults of the parameters this is {number}: {WHAT} is not negative"
            );
            return errors.report(value.extent, message);
        }
        Some(Some(armature))
    }
}

fn constant(lowering: &mut Lowering<'_>, written: &Expression, dimension: Dimension) -> Option<Id> {
    let value = lowering.scalar(written, dimension, WHAT)?;
    lowering.check_early(written, &[value], &format!("{WHAT} is fixed"))?;
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

fn is_negative(number: &Number) -> bool {
    !number.is_zero() && !number.is_positive()
}

/// The armatures, which `new` checks if they depend on parameters.
pub fn armatures(joints: &[TreeJoint]) -> Vec<Property> {
    let written = joints.iter().filter_map(|joint| {
        Some(Property {
            of: joint.name.clone(),
            word: "armature",
            value: joint.armature?,
            may_vanish: true,
        })
    });
    written.collect()
}
