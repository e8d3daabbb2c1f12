//! The context in which the parts of a system are read, and the definitions outside its bodies.

use std::collections::HashSet;

use crate::errors::Errors;
use crate::lower::definitions::{
    Definition, INVERSE, check_circles, check_names, definition_order,
};
use crate::lower::expressions::{Lowering, Members, Offset, Scope, Value};
use crate::model::{
    Constraints, Declared, Defaults, Drawn, Frame, Meaning, Motion, Outline, PLANAR, Point,
    SPATIAL, State, Vector, Workspace,
};
use crate::symbolic::{Id, Stage};
use crate::syntax;

use super::names::{check_driving, check_members, declared, late_locals, moving_locals};

/// The context in which the parts of a system are read.
pub struct Reader<'a> {
    pub system: &'a syntax::System,
    pub work: Workspace,
    pub scope: Scope,
    pub members: Members,
    pub motion: Motion,
    /// Whether drives are solved for.
    pub is_inverse: bool,
    /// For each body, whether its joints let it rotate.
    pub turning: Vec<bool>,
    /// Whether each body is a frame that moves by itself.
    pub massless: Vec<bool>,
    pub time: Id,
    pub defaults: Defaults,
    /// The number of given derivatives of each input.
    pub derivatives: Vec<usize>,
    /// The constraints read so far; `None` if an error in one was reported.
    pub kept: Option<Constraints>,
    /// The index of the load of the first constraint among the parts of reactions.
    pub first_load: usize,
}

impl<'a> Reader<'a> {
    /// Begins to read: only names are known so far.
    pub fn new(
        system: &'a syntax::System,
        outline: &mut Outline,
        mut work: Workspace,
        errors: &mut Errors,
    ) -> Self {
        let mut repeated = check_names(&system.top, errors);
        repeated.extend(check_members(system, errors));
        check_driving(system, outline, errors);
        let time = work.symbol(Stage::State, Meaning::Time);
        Self {
            system,
            work,
            scope: Scope::new(&system.top, repeated),
            members: Members {
                declared: declared(system),
                late: late_locals(system),
                ..Members::default()
            },
            is_inverse: outline.rank(INVERSE).is_some(),
            turning: vec![false; system.bodies.len()],
            massless: vec![false; system.bodies.len()],
            motion: if system.is_planar { &PLANAR } else { &SPATIAL },
            time,
            defaults: Defaults::new(),
            derivatives: Vec::new(),
            kept: Some(Constraints::default()),
            first_load: 2 * outline.holding.len(),
        }
    }

    /// Reads params, inputs, and the locals that do not depend on the motion.
    pub fn fixed(&mut self, outline: &mut Outline, errors: &mut Errors) {
        let top = &self.system.top;
        self.defaults = self.at_top(errors, |lowering| lowering.declarations(top, outline));
        self.derivatives = outline.inputs.iter().map(Declared::derivatives).collect();
        self.locals(errors, false);
    }

    /// Reads something outside the bodies.
    pub fn at_top<T>(
        &mut self,
        errors: &mut Errors,
        read: impl FnOnce(&mut Lowering<'_>) -> T,
    ) -> T {
        let mut state = still(Frame::WORLD, self.time);
        read(&mut Lowering {
            work: &mut self.work,
            scope: &mut self.scope,
            errors,
            motion: self.motion,
            state: &mut state,
            reactions: names_of_constraints(&self.system.top),
            is_constrained: true,
            composed: None,
            has_parts: false,
            drawn: Drawn::Alone,
            members: &self.members,
            is_whole: true,
        })
    }

    /// The locals of the system: first those that use no body or joint, and later the others.
    pub fn locals(&mut self, errors: &mut Errors, is_late: bool) {
        let locals = &self.system.top.locals;
        let moves = moving_locals(self.system);
        let (order, circular) = definition_order(&self.system.top);
        if is_late {
            check_circles(&self.system.top, |name| self.scope.is_lost(name), errors);
        }
        for definition in circular {
            self.scope.define(&definition.of(&self.system.top).0, None);
        }
        for definition in order {
            let Definition::Local(index) = definition else {
                continue;
            };
            let local = &locals[index];
            let name = local.name.to_string();
            if moves.contains(&name) != is_late {
                continue;
            }
            let value = self.at_top(errors, |lowering| {
                let value = lowering.value(local.value.as_ref()?)?;
                Some(lowering.named(value, &name))
            });
            self.scope.define(&name, value);
        }
    }
}

/// The names of constraints, which are also those of their loads.
pub fn names_of_constraints(description: &syntax::Description) -> Vec<String> {
    let written = description.constraints.iter();
    written.map(|one| one.name.to_string()).collect()
}

/// The state of a body whose motion is unknown.
pub fn still(body: Frame, time: Id) -> State {
    let zeros = Workspace::default().graph.zeros();
    State {
        body,
        axes: body,
        time,
        position: Vector::ZERO,
        velocity: Vector::ZERO,
        acceleration: Vector::ZERO,
        angle: None,
        angular_velocity: zeros,
        angular_acceleration: zeros,
        axis: None,
        support: None,
        swings: false,
    }
}

/// The points of a body, by the names that others use; `late` are names that have no value yet.
pub fn points(
    work: &mut Workspace,
    scope: &Scope,
    body: &syntax::Description,
    (frame, late): (Frame, &HashSet<String>),
) -> Vec<(String, Offset)> {
    let names = body.points.iter().map(|point| point.name.to_string());
    names
        .filter_map(|name| {
            let offset = match scope.peek(&name) {
                Some(Value::Point(Point::Fixed(of, offset))) if of == frame => {
                    Offset::Known(work.vector(frame, offset))
                }
                Some(Value::Point(Point::Moving(offset))) => Offset::Known(offset),
                Some(Value::Point(Point::Fixed(..))) => return None,
                _ if late.contains(&name) => Offset::Late,
                _ => Offset::Reported,
            };
            Some((name, offset))
        })
        .collect()
}
