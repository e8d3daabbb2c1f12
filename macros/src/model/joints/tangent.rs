//! The tangent space of states: how a motion can change.

use crate::model::words::Variable;

use super::shape::{Field, Shape};

/// A group of coordinates of the tangent space, or of accelerations.
#[derive(Clone, Debug)]
pub struct Group {
    /// For a system, the index of the joint in its state.
    pub joint: usize,
    pub name: String,
    /// Its variable. An attitude changes by small angles about the axes of the rotated body, so its
    /// variable is the quaternion, but the group has three components.
    pub variable: Variable,
    /// The index of the first component.
    pub first: usize,
    pub size: usize,
}

impl Shape {
    /// The groups of coordinates; the rates come after them.
    pub fn places(&self, joint: usize, prefix: &str) -> Vec<Group> {
        self.groups(joint, prefix, |variable| !variable.is_rate())
    }

    /// The groups of rates, in the order of the accelerations.
    pub fn rates(&self, joint: usize, prefix: &str) -> Vec<Group> {
        self.groups(joint, prefix, Variable::is_rate)
    }

    /// The groups of accelerations: `linear`, `angular`, `axis`.
    pub fn accelerations(&self, joint: usize, prefix: &str) -> Vec<Group> {
        let second = self.second.iter();
        let groups = second.map(|field| Group {
            name: format!("{prefix}{}", field.variable.of_acceleration()),
            ..field.group(joint)
        });
        groups.collect()
    }

    fn groups(&self, joint: usize, prefix: &str, has: impl Fn(Variable) -> bool) -> Vec<Group> {
        let fields = self.fields.iter().filter(|field| has(field.variable));
        let groups = fields.map(|field| {
            let name = field.path.split('.').next().unwrap_or_default();
            Group {
                name: format!("{prefix}{name}"),
                ..field.group(joint)
            }
        });
        groups.collect()
    }
}

impl Field {
    fn group(&self, joint: usize) -> Group {
        let is_attitude = self.variable == Variable::Quaternion;
        Group {
            joint,
            name: String::new(),
            variable: self.variable,
            first: self.first,
            size: if is_attitude { 3 } else { self.names.len() },
        }
    }
}
