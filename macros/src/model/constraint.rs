//! Constraints: `name = expression`, kept at zero.

use proc_macro2::Ident;

use crate::symbolic::{Id, Node};
use crate::syntax::Definition;

use super::frame::Frame;
use super::lower::Lowering;
use super::motion::Meanings;
use super::names::{AXES, Meaning};
use super::value::Value;

/// A scalar that the motion keeps at zero.
pub struct Constraint {
    /// Its name; of a component of a vector, `pin.x`.
    pub name: String,
    /// The name as it was written.
    pub place: Ident,
    pub level: Level,
    pub value: Id,
}

/// What a constraint speaks of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Level {
    /// Of where the body is: differentiated twice.
    Position,
    /// Of how it moves: differentiated once.
    Velocity,
}

impl Lowering<'_> {
    /// The scalars of one constraint: a vector counts as its components, in world axes unless it
    /// says otherwise.
    pub fn constraint(
        &mut self,
        written: &Definition,
        meanings: &Meanings,
    ) -> Option<Vec<Constraint>> {
        let expression = written.value.as_ref()?;
        let name = &written.name;
        if self.motion.is_supported() {
            let motion = self.motion.word();
            return self.report(
                name.span(),
                format!(
                    "constraints beside a support are not there yet: instead of `motion: \
                     {motion}(..)`, write the support as a constraint too"
                ),
            );
        }
        let components = match self.value(expression)? {
            Value::Scalar(id, _) => vec![(name.to_string(), id)],
            Value::Components(_, components, _) => self.named_components(name, components),
            Value::Vector(vector, _) => {
                let components = self.frames.components(vector, Frame::World);
                self.named_components(name, components)
            }
            other => {
                return self.report(
                    expression.extent,
                    format!(
                        "a constraint is a scalar or a vector that is kept at zero, and this is {}",
                        other.kind()
                    ),
                );
            }
        };
        let mut constraints = Vec::new();
        for (scalar, value) in components {
            let Some(level) = self.level(value, meanings) else {
                return self.report(
                    name.span(),
                    format!(
                        "`{scalar}` does not depend on where the body is or how it moves: no load \
                         can keep it at zero"
                    ),
                );
            };
            constraints.push(Constraint {
                name: scalar,
                place: name.clone(),
                level,
                value,
            });
        }
        Some(constraints)
    }

    fn named_components(&self, name: &Ident, components: [Id; 3]) -> Vec<(String, Id)> {
        let axes = self.motion.axes();
        let named = components.into_iter().zip(AXES).take(axes);
        named
            .map(|(id, axis)| (format!("{name}.{axis}"), id))
            .collect()
    }

    /// `None` of what depends on no part of the state.
    fn level(&self, value: Id, meanings: &Meanings) -> Option<Level> {
        let graph = &self.frames.graph;
        let depends = |wanted: fn(Meaning) -> bool| {
            graph.depends_on(
                &[value],
                |id| matches!(graph.node(id), Node::Symbol(symbol) if wanted(meanings.of(*symbol))),
            )
        };
        let is_rate = |meaning| {
            matches!(
                meaning,
                Meaning::Velocity(_) | Meaning::AngularVelocity(_) | Meaning::AxisRate(_)
            )
        };
        if depends(is_rate) {
            return Some(Level::Velocity);
        }
        let is_place = |meaning| {
            matches!(
                meaning,
                Meaning::Position(_) | Meaning::Angle | Meaning::Quaternion(_) | Meaning::Axis(_)
            )
        };
        depends(is_place).then_some(Level::Position)
    }
}
