//! Names: what was defined, and what every description knows without defining it.

use proc_macro2::Ident;

use crate::model::{Attitude, Dimension, Frame};
use crate::symbolic::Number;

use super::along_axis::UNTURNED;
use super::lowering::Lowering;
use super::scope::BUILT_IN;
use super::value::Value;

impl Lowering<'_> {
    pub fn name(&mut self, name: &Ident) -> Option<Value> {
        let word = name.to_string();
        if let Some(value) = self.scope.look_up(&word) {
            return value;
        }
        self.check_has_body(name)?;
        let graph = &mut self.work.graph;
        match word.as_str() {
            "t" => Some(Value::Scalar(self.state.time, Dimension::TIME)),
            "PI" => Some(Value::Scalar(graph.number(Number::pi()), Dimension::ANY)),
            "TAU" => Some(Value::Scalar(
                graph.number(Number::pi() * Number::integer(2)),
                Dimension::ANY,
            )),
            "G" => Some(Value::Point(self.state.mass_center(self.work))),
            "position" | "velocity" => self.motion_of_center(name),
            "axis" | "axis_rate" if self.motion.is_line() => {
                let axis = self.state.axis?;
                let (components, dimension) = if word == "axis" {
                    (axis.unit, Dimension::NONE)
                } else {
                    (axis.rate, Dimension::FREQUENCY)
                };
                let vector = self.work.vector(Frame::WORLD, components);
                Some(Value::Vector(vector, dimension))
            }
            "attitude" if self.motion.is_line() => self.report(
                name.span(),
                format!("{UNTURNED}: write `axis`, the unit vector along it"),
            ),
            "attitude" if !self.motion.has_attitude() => self.absent(name, "attitude"),
            "attitude" => match self.work.attitude(self.state.body) {
                Attitude::Axis { angle, .. } => Some(Value::Scalar(angle, Dimension::NONE)),
                _ => Some(Value::Attitude),
            },
            "angular_velocity" if !self.motion.has_attitude() => {
                self.absent(name, "angular velocity")
            }
            "angular_velocity" if self.motion.is_planar => Some(Value::Scalar(
                self.state.angular_velocity[2],
                Dimension::FREQUENCY,
            )),
            "angular_velocity" => {
                let (axes, w) = (self.state.axes, self.state.angular_velocity);
                let vector = self.work.vector(axes, w);
                Some(Value::Vector(vector, Dimension::FREQUENCY))
            }
            _ => self.unknown_name(name),
        }
    }

    /// Beside the bodies of a system, what belongs to a body is named with it.
    pub fn check_has_body(&mut self, name: &Ident) -> Option<()> {
        let word = name.to_string();
        let of_body = BUILT_IN.contains(&word.as_str())
            && !["t", "world", "PI", "TAU"].contains(&word.as_str());
        if !self.is_whole || !of_body {
            return Some(());
        }
        let body = self.members.declared.first();
        let body = body.map_or("arm", String::as_str);
        let call = if word == "body" { "(..)" } else { "" };
        let message = format!("of which body? write for example `{body}.{word}{call}`");
        self.report(name.span(), message)
    }

    /// A name that has no value, or none here.
    fn unknown_name(&mut self, name: &Ident) -> Option<Value> {
        let word = name.to_string();
        let message = match word.as_str() {
            "mass" => "this body has no mass: write `mass: ..`".to_owned(),
            keyword if keyword.starts_with("r#") => {
                format!("`{}` is a keyword of Rust, and no name here", &keyword[2..])
            }
            "body" | "world" => {
                format!("`{word}` makes a vector: write `{word}(..)` with components")
            }
            _ if self.reactions.contains(&word) && self.is_constrained => format!(
                "`{word}` is an unknown reaction, and only given loads can depend on it: write \
                 this out in the load"
            ),
            _ if self.reactions.contains(&word) => format!(
                "`{word}` is an unknown reaction, and only given loads of a body with `constraints` \
                 can depend on one"
            ),
            _ if self.members.declared.contains(&word) || self.members.late.contains(&word) => {
                format!(
                    "this is fixed, and `{word}` moves: it cannot depend on how the system moves"
                )
            }
            _ => {
                let of_body = self.members.with_body(&word).filter(|_| self.is_whole);
                of_body.map_or_else(
                    || {
                        let hint = self.members.hint(&word, self.scope.known());
                        format!("nothing here is called `{word}`{hint}")
                    },
                    |named| format!("of which body? write for example `{named}`"),
                )
            }
        };
        self.report(name.span(), message)
    }

    fn absent(&mut self, name: &Ident, what: &str) -> Option<Value> {
        self.report(
            name.span(),
            format!("under `motion: {}` a body has no {what}", self.motion.word),
        )
    }

    fn motion_of_center(&mut self, name: &Ident) -> Option<Value> {
        if !self.motion.knows_position() {
            return self.report(
                name.span(),
                format!(
                    "`{name}` is not known under `motion: rotation`: the motion of G is not \
                     modelled"
                ),
            );
        }
        self.check_support_is_read(name)?;
        Some(if name == "position" {
            Value::Vector(self.state.position, Dimension::LENGTH)
        } else {
            Value::Vector(self.state.velocity, Dimension::VELOCITY)
        })
    }

    /// What a support is made of cannot depend on the motion that it allows.
    pub fn check_support_is_read(&mut self, place: &Ident) -> Option<()> {
        if self.motion.is_supported() && self.state.support.is_none() {
            return self.report(
                place.span(),
                "a support is fixed: it cannot depend on the motion of the body",
            );
        }
        Some(())
    }
}
