//! Checks that the links of a file are connected, and have mass where they move.

use proc_macro2::{Ident, Span};

use crate::errors::Errors;
use crate::syntax::expression::{Expression, Kind};

use super::robot::{Inertial, Joint, Motion, Robot};
use crate::syntax::xml::Beside;

impl Joint {
    /// Whether it holds its child rigidly.
    pub fn is_rigid(&self) -> bool {
        self.kind == Motion::Fixed || self.locked.is_some()
    }
}

impl Robot {
    /// The root, which no joint carries, if it carries all other links directly or indirectly; and
    /// for each link the joint that carries it.
    pub fn tree(
        &self,
        (name, span): (&str, Span),
        errors: &mut Errors,
    ) -> Option<(usize, Vec<Option<usize>>)> {
        let mut carried: Vec<Option<usize>> = vec![None; self.links.len()];
        let mut is_sound = true;
        for (number, joint) in self.joints.iter().enumerate() {
            match carried[joint.child] {
                None => carried[joint.child] = Some(number),
                Some(other) => {
                    is_sound = false;
                    let (link, other) = (&self.links[joint.child].name, &self.joints[other].name);
                    errors.push(
                        joint.extent,
                        format!("link `{link}` is the child of joint `{other}` already: a link has one parent"),
                    );
                }
            }
        }
        if !is_sound {
            return None;
        }
        let roots: Vec<usize> = (0..carried.len())
            .filter(|link| carried[*link].is_none())
            .collect();
        let [root] = roots.as_slice() else {
            if let Some((first, others)) = roots.split_first() {
                let first = &self.links[*first].name;
                for other in others {
                    let message = format!(
                        "no joint carries this link, and none carries `{first}`: one of them is the root"
                    );
                    errors.push(self.links[*other].extent, message);
                }
            } else {
                let message =
                    format!("{name}: the joints run in a circle, and no link is the root");
                errors.push(span, message);
            }
            return None;
        };
        // there is only one root, so links that it does not carry form a cycle
        let hangs = |link: usize| {
            let mut above = link;
            for _ in 0..carried.len() {
                above = carried[above].map_or(above, |joint| self.joints[joint].parent);
            }
            above == *root
        };
        if let Some(joint) = self.joints.iter().find(|joint| !hangs(joint.child)) {
            let message = "this joint is part of a circle of joints, or carried by one";
            return errors.report(joint.extent, message);
        }
        Some((*root, carried))
    }

    /// Checks that each rigid group that moves has mass; `added` are the links to which the
    /// description adds mass.
    pub fn check_masses(
        &self,
        carried: &[Option<usize>],
        (root, root_moves): (usize, bool),
        added: &[usize],
        errors: &mut Errors,
    ) {
        // for each link, the first link of its rigid group: the one below all fixed joints
        let first = |link: usize| {
            let mut first = link;
            while let Some(joint) = carried[first].map(|joint| &self.joints[joint]) {
                if !joint.is_rigid() {
                    break;
                }
                first = joint.parent;
            }
            first
        };
        let mut has_mass = vec![false; self.links.len()];
        for (number, link) in self.links.iter().enumerate() {
            if !matches!(link.inertial, Inertial::Absent) || added.contains(&number) {
                has_mass[first(number)] = true;
            }
        }
        for (number, link) in self.links.iter().enumerate() {
            let moves = match carried[number] {
                None => number == root && root_moves,
                Some(joint) => !self.joints[joint].is_rigid(),
            };
            if moves && !has_mass[number] {
                let how = match carried[number].map(|joint| &self.joints[joint]) {
                    Some(joint) if joint.kind != Motion::Free && joint.kind != Motion::Plane => {
                        let (name, ident) = (&joint.name, &joint.ident);
                        format!(
                            "joint `{name}` moves it, and it has no mass: write its `<inertial>`, or `locked: [{ident} = 0]`"
                        )
                    }
                    _ => "it moves, and it has no mass: write its `<inertial>`".to_owned(),
                };
                errors.push(link.extent, how);
            }
        }
    }

    /// Checks the parents of floating joints: such a joint moves its child relative to the ground.
    pub fn check_floating(&self, carried: &[Option<usize>], root_moves: bool, errors: &mut Errors) {
        for joint in &self.joints {
            if joint.kind == Motion::Free && !self.is_held(carried, joint.parent, root_moves) {
                let parent = &self.links[joint.parent].name;
                let message = format!("a floating joint is to the ground, and `{parent}` moves");
                errors.push(joint.extent, message);
            }
        }
    }

    /// Whether a link is fixed to the ground.
    fn is_held(&self, carried: &[Option<usize>], link: usize, root_moves: bool) -> bool {
        let mut link = link;
        while let Some(joint) = carried[link].map(|joint| &self.joints[joint]) {
            if !joint.is_rigid() {
                return false;
            }
            link = joint.parent;
        }
        !root_moves
    }
}

/// `name` in a joint `free(name)` or `kind(P, name.Q, ..)`, with or without methods after it.
fn carried_by(joint: &Expression) -> Option<&Ident> {
    let mut inner = joint;
    while let Kind::Method(receiver, _, _) = &inner.kind {
        inner = receiver;
    }
    let Kind::Call(_, arguments) = &inner.kind else {
        return None;
    };
    match arguments.as_slice() {
        [
            Expression {
                kind: Kind::Name(name),
                ..
            },
            ..,
        ] => Some(name),
        [_, point, ..] => point.names().into_iter().next(),
        _ => None,
    }
}

/// Whether the joint that carries a body is a weld.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Welded {
    Yes,
    No,
}

impl Beside<'_> {
    /// Whether the description has a joint that carries a body with this name, and whether it is a
    /// weld.
    pub fn is_carried(self, name: &Ident) -> Option<Welded> {
        let mut joints = self.joints.iter().filter_map(|joint| joint.value.as_ref());
        let joint = joints.find(|joint| carried_by(joint) == Some(name))?;
        Some(if is_weld(joint) {
            Welded::Yes
        } else {
            Welded::No
        })
    }

    /// Whether the description gives mass to a link.
    pub fn gives_mass(self, link: &Ident) -> bool {
        let mut bodies = self.bodies.iter();
        bodies.any(|body| body.name == *link && (body.mass.is_some() || body.inertia.is_some()))
    }

    /// The links that get mass from the description, directly or by welded bodies.
    pub fn massive(self, robot: &Robot) -> Vec<usize> {
        let joints = self.joints.iter().filter_map(|joint| joint.value.as_ref());
        let welded = joints
            .filter(|joint| is_weld(joint))
            .flat_map(Expression::names);
        let welded: Vec<&Ident> = welded.collect();
        let is_massive = |link: &Ident| welded.contains(&link) || self.gives_mass(link);
        let links = robot.links.iter().enumerate();
        links
            .filter(|(_, link)| is_massive(&link.ident))
            .map(|(number, _)| number)
            .collect()
    }
}

fn is_weld(joint: &Expression) -> bool {
    let mut inner = joint;
    while let Kind::Method(receiver, _, _) = &inner.kind {
        inner = receiver;
    }
    matches!(&inner.kind, Kind::Call(word, _) if word == "weld")
}
