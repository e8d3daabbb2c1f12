//! The bodies of a system. Their points are read first, and everything else once their motion is
//! known.

use std::collections::HashSet;
use std::ops::Range;

use crate::errors::{Errors, Extent, every};
use crate::families::LoadKind;
use crate::lower::definitions::{
    Definition, check_circles, check_names, definition_order, split_at_points,
};
use crate::lower::expressions::{BodyNames, Lowering, Scope, Value};
use crate::model::{
    Composed, Declared, Dimension, Drawn, Frame, Inertia, Load, Mass, Meaning, Member, State,
    Workspace,
};
use crate::symbolic::{Components, Stage};
use crate::syntax::{self, Description, Kind};

use super::names::{check_own_names, for_copy};
use super::reader::{Reader, names_of_constraints, points, still};

/// A body whose points are read.
pub struct Draft<'a> {
    pub description: &'a Description,
    pub frame: Frame,
    pub scope: Scope,
    pub mass: Mass,
    pub composed: Option<Composed>,
    pub drawn: Drawn,
    /// Points that depend on the motion of the body, and what they depend on.
    pub late: Vec<Definition>,
    /// The state, once the joints are known.
    pub state: Option<State>,
}

impl<'a> Reader<'a> {
    /// Reads the points and the mass of a body, and registers them, for others to use.
    pub fn points(
        &mut self,
        number: usize,
        body: &'a Description,
        errors: &mut Errors,
    ) -> Draft<'a> {
        let frame = self.work.new_frame(Frame::WORLD);
        let mut repeated = check_names(body, errors);
        repeated.extend(check_own_names(self.system, body, errors));
        let is_frame = body.is_frame;
        let mut draft = Draft {
            description: body,
            frame,
            scope: Scope::new(body, repeated),
            mass: if is_frame {
                Mass::Known(self.work.graph.zero())
            } else {
                Mass::Reported
            },
            composed: None,
            drawn: self.drawn(number, body, errors),
            late: Vec::new(),
            state: Some(self.unknown_state(frame)),
        };
        check_circles(body, |name| draft.scope.is_lost(name), errors);
        let (order, circular) = definition_order(body);
        let (first, _) = split_at_points(body, &order);
        let defaults = self.defaults.clone();
        let late = self.in_body(&mut draft, errors, |lowering, mass| {
            if let Some(zero) = mass.known().filter(|_| is_frame) {
                let zero = Value::Scalar(zero, Dimension::MASS);
                lowering.scope.define("mass", Some(zero));
            } else {
                lowering.check_mass_key(body, true);
            }
            let late = lowering.fixed_definitions(&first, body, &defaults, mass);
            for definition in circular {
                lowering.scope.define(&definition.of(body).0, None);
            }
            late
        });
        let names = late.iter().map(|one| one.of(body).0).collect();
        draft.late = late;
        draft.state = None;
        let mass = draft.mass.known();
        let composed = draft.composed.map(|composed| composed.origin);
        let values = mass.map(|mass| ("mass", Value::Scalar(mass, Dimension::MASS)));
        self.members.bodies.push(BodyNames {
            name: body.name.to_string(),
            frame,
            origin: composed.or(draft.drawn.origin()),
            points: points(&mut self.work, &draft.scope, body, (frame, &names)),
            motion: None,
            values: values.into_iter().collect(),
        });
        draft
    }

    /// Reads the points that depend on the motion of bodies, once it is known or replaced.
    pub fn late_points(&mut self, drafts: &mut [Draft<'_>], errors: &mut Errors) {
        let defaults = self.defaults.clone();
        let mut wrong = HashSet::new();
        for (number, draft) in drafts.iter_mut().enumerate() {
            let late = draft.late.clone();
            if late.is_empty() || draft.state.is_none() {
                continue;
            }
            let (body, first) = (draft.description, self.system.firsts[number]);
            for_copy(first, number, &mut wrong, errors, |errors| {
                self.in_body(draft, errors, |lowering, mass| {
                    for definition in late {
                        lowering.scope.forget(&definition.of(body).0);
                        lowering.definition(definition, body, &defaults, mass);
                    }
                });
            });
            let told = (draft.frame, &HashSet::new());
            self.members.bodies[number].points = points(&mut self.work, &draft.scope, body, told);
        }
    }

    /// The place of G of a body in a drawing. For composed bodies, it follows from the parts.
    fn drawn(&mut self, number: usize, body: &Description, errors: &mut Errors) -> Drawn {
        match self.system.centers.as_ref().and_then(|all| all.get(number)) {
            Some(center) if body.composition.is_none() => {
                let origin = self.drawn_center(center, &body.name, errors);
                origin.map_or(Drawn::Lost, Drawn::From)
            }
            _ => Drawn::Alone,
        }
    }

    /// A state of symbols, for a body whose motion is unknown.
    fn unknown_state(&mut self, frame: Frame) -> State {
        let kinds = [LoadKind::Force, LoadKind::Moment];
        let [axes, turning] = kinds.map(|kind| kind.axes(self.system.is_planar));
        let still = still(frame, self.time);
        let work = &mut self.work;
        let mut unknown =
            |axes: &Range<usize>| work.symbols(Stage::State, axes.clone(), |_| Meaning::Virtual);
        let [position, velocity, angular_velocity] = [&axes, &axes, &turning].map(&mut unknown);
        let mut state = State {
            angular_velocity,
            ..still
        };
        if self.system.mentions_accelerations {
            let acceleration = unknown(&axes);
            state.angular_acceleration = unknown(&turning);
            state.acceleration = work.vector(Frame::WORLD, acceleration);
        }
        State {
            position: work.vector(Frame::WORLD, position),
            velocity: work.vector(Frame::WORLD, velocity),
            ..state
        }
    }

    /// Reads a part of a body. It can use the declarations of the whole system.
    pub fn in_body<T>(
        &mut self,
        draft: &mut Draft<'_>,
        errors: &mut Errors,
        read: impl FnOnce(&mut Lowering<'_>, &mut Mass) -> T,
    ) -> T {
        let names = self.scope.values();
        for (name, value) in &names {
            draft.scope.define(name, *value);
        }
        let mut state = draft.state.take().unwrap_or_else(|| State {
            // the error in its joint is reported, and says nothing about the inertia
            swings: true,
            ..still(draft.frame, self.time)
        });
        let mut lowering = Lowering {
            work: &mut self.work,
            scope: &mut draft.scope,
            errors,
            motion: self.motion,
            state: &mut state,
            reactions: [&self.system.top, draft.description]
                .map(names_of_constraints)
                .concat(),
            is_constrained: true,
            composed: draft.composed,
            has_parts: draft.description.composition.is_some(),
            drawn: draft.drawn,
            members: &self.members,
            is_whole: false,
        };
        let result = read(&mut lowering, &mut draft.mass);
        draft.composed = lowering.composed;
        draft.state = Some(state);
        for name in names.keys() {
            if draft.scope.has_used(name) {
                self.scope.look_up(name);
            }
        }
        result
    }

    /// Reads everything that depends on the motion of the bodies: their other definitions, inertia
    /// and loads.
    pub fn bodies(
        &mut self,
        drafts: &mut [Draft<'_>],
        wrong: &mut HashSet<usize>,
        inputs: &[Declared],
        errors: &mut Errors,
    ) -> Option<Vec<Member>> {
        let mut bodies = Some(Vec::new());
        let mut reported = HashSet::new();
        for (number, draft) in drafts.iter_mut().enumerate() {
            let first = self.system.firsts[number];
            // errors in the points of a copy do not hide errors in other parts of the first body
            let silent = if wrong.contains(&first) && first != number {
                &mut *wrong
            } else {
                &mut reported
            };
            let is_silent = first != number && silent.contains(&first);
            let read = for_copy(first, number, silent, errors, |errors| {
                self.body(number, draft, inputs, errors)
            });
            if is_silent {
                // its direction is its own
                let body = draft.description;
                self.in_body(draft, errors, |lowering, _| lowering.check_direction(body));
            }
            match (read, &mut bodies) {
                (Some(body), Some(all)) => all.push(body),
                _ => bodies = None,
            }
        }
        bodies
    }

    fn body(
        &mut self,
        number: usize,
        draft: &mut Draft<'_>,
        inputs: &[Declared],
        errors: &mut Errors,
    ) -> Option<Member> {
        let body = draft.description;
        let (order, _) = definition_order(body);
        let (_, rest) = split_at_points(body, &order);
        let defaults = self.defaults.clone();
        let fields = &self.system.top.loads;
        let turns = self.turning[number];
        let known = draft.state.is_some();
        let kept = self.kept.as_ref().map_or(0, |kept| kept.list.len());
        let first = self.first_load + kept;
        let (inertia, loads, mass, kept) = self.in_body(draft, errors, |lowering, mass| {
            for definition in rest {
                lowering.definition(definition, body, &defaults, mass);
            }
            let is_idle = body.is_frame || !turns && body.inertia.is_none();
            let inertia = if is_idle {
                Some(Inertia::Absent)
            } else {
                lowering.inertia(body, *mass, &defaults)
            };
            // fields do not act on a frame
            let fields = fields.iter().filter(|_| !body.is_frame);
            let written = fields.chain(&body.loads);
            let kept = known.then(|| lowering.kept(body, inputs, first)).flatten();
            // fields on charges are potentials
            let written = written.filter(|load| known && load.charges.is_none());
            let loads = every(written.map(|load| {
                if let Some(unknown) = first_unknown(load) {
                    let message = "nothing of a load on a body is unknown: what joints do is found by \
                         `outputs: [reactions]`, so write a value";
                    return lowering.report(unknown, message);
                }
                lowering.load(load)
            }));
            (inertia, loads, *mass, kept)
        });
        self.keep(kept, Some(&body.name));
        Some(Member {
            name: body.name.clone(),
            state: draft.state.filter(|_| known)?,
            mass: mass.known()?,
            inertia: inertia?,
            loads: loads?,
            weights: Vec::new(),
            felt: None,
        })
    }
}

/// The first `_` of a load.
fn first_unknown(load: &syntax::Load) -> Option<Extent> {
    let mut found = None;
    load.vector.as_ref()?.visit(|part| {
        if matches!(part.kind, Kind::Placeholder) {
            found = found.or(Some(part.extent));
        }
    });
    found
}

/// Removes from all bodies the fields in which they fall with the same acceleration, and returns
/// this acceleration. The first `fields` loads of each body are the fields of the system, in their
/// order.
pub fn common_gravity(work: &mut Workspace, bodies: &mut [Member], fields: usize) -> Components {
    let mut gravity = work.graph.zeros();
    let mut bodies: Vec<&mut Member> = bodies
        .iter_mut()
        .filter(|body| !work.graph.is_zero(body.mass))
        .collect();
    for field in (0..fields).rev() {
        let falls: Vec<Option<Components>> = bodies
            .iter()
            .map(|body| fall(work, body, &body.loads[field]))
            .collect();
        let Some(Some(fall)) = falls.first() else {
            continue;
        };
        if falls.iter().all(|other| other.as_ref() == Some(fall)) {
            gravity = work.graph.add_vectors(gravity, *fall);
            for body in &mut bodies {
                let weight = body.loads.remove(field);
                body.weights.insert(0, weight);
            }
        }
    }
    gravity
}

/// The acceleration that a field gives to a body, if the field acts at G and is the same in all
/// states.
fn fall(work: &mut Workspace, body: &Member, load: &Load) -> Option<Components> {
    let offset = load.point.offset(body.state.body);
    let at_center = offset.is_some_and(|offset| work.graph.is_zero_vector(&offset));
    let is_uniform = work.is_in(load.force, Frame::WORLD) && load.moment.is_zero() && at_center;
    let force = work.part(load.force, Frame::WORLD);
    let fall = force.map(|part| work.graph.divide(part, body.mass));
    (is_uniform && work.graph.are_early(&fall)).then_some(fall)
}
