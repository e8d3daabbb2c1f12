//! `wire.gradient()`: the direction in which a smooth support that keeps the constraint `wire`
//! pushes.

use proc_macro2::Ident;

use crate::model::{Dimension, Frame, Level, Vector};
use crate::symbolic::{Components, Id, Node};
use crate::syntax::{Expression, Kind};

use super::lowering::Lowering;
use super::scope::{Kept, Value};

impl Lowering<'_> {
    /// The gradient of the constraint that the receiver names. `None` stands for any other
    /// receiver.
    #[allow(
        clippy::option_option,
        reason = "outer: another expression; inner: reported"
    )]
    pub fn gradient(
        &mut self,
        receiver: &Expression,
        method: &Ident,
        arguments: &[Expression],
    ) -> Option<Option<Value>> {
        if method != "gradient" {
            return None;
        }
        let name = constraint_name(receiver)?;
        let vector = name.split_once('.').map(|(vector, _)| vector);
        let kept = self.scope.constraint(&name).or_else(|| {
            let whole = self.scope.constraint(vector?)?;
            matches!(whole, Kept::Unread | Kept::Reported).then_some(whole)
        })?;
        if self.expect_arguments(method, arguments, 0).is_none() {
            return Some(None);
        }
        if self.members.is_system() {
            let message =
                format!("in a system, `{name}` pushes along its gradient without being told");
            return Some(self.report(method.span(), message));
        }
        let found = match kept {
            Kept::Scalar(value, level) => self.gradient_of(value, level),
            Kept::Reported => return Some(None),
            Kept::Unread => {
                let message = format!(
                    "`{name}` is a constraint, which is read after this: only `reactions` and given \
                     loads can be along its gradient"
                );
                return Some(self.report(method.span(), message));
            }
            Kept::Vector => {
                let message = format!(
                    "`{name}` is a vector: write the gradients of its components, such as `{name}.x.gradient()`"
                );
                return Some(self.report(method.span(), message));
            }
        };
        Some(if found.is_zero() {
            self.report(
                method.span(),
                format!(
                    "`{name}` has no gradient along the coordinates of G {}: write the direction, \
                     or a moment",
                    self.under()
                ),
            )
        } else {
            Some(Value::Vector(found, Dimension::NONE))
        })
    }

    /// The derivative with respect to the position of G, in world axes; of a constraint of
    /// velocities, with respect to its velocity. A direction has no unit, so it is scaled.
    fn gradient_of(&mut self, value: Id, level: Level) -> Vector {
        let coordinates = match level {
            Level::Position => self.state.position,
            Level::Velocity => self.state.velocity,
        };
        let coordinates = self.work.components(coordinates, Frame::WORLD);
        let graph = &mut self.work.graph;
        let slopes: Components = coordinates.map(|coordinate| {
            if matches!(graph.node(coordinate), Node::Symbol(_)) {
                graph.derivative(&[value], coordinate)[0]
            } else {
                graph.zero()
            }
        });
        self.work.vector(Frame::WORLD, slopes)
    }
}

/// The constraint whose gradient is in this direction.
pub fn of_gradient(direction: &Expression) -> Option<String> {
    let mut found = None;
    direction.visit(|part| {
        if let Kind::Method(receiver, method, _) = &part.kind
            && method == "gradient"
        {
            found = constraint_name(receiver);
        }
    });
    found
}

/// `wire`, or `pin.x` for a component of a vector.
fn constraint_name(receiver: &Expression) -> Option<String> {
    match &receiver.kind {
        Kind::Name(name) => Some(name.to_string()),
        Kind::Field(vector, axis) => Some(format!("{}.{axis}", constraint_name(vector)?)),
        _ => None,
    }
}
