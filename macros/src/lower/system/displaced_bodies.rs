//! Quantities that depend on the motion of bodies, read with each body displaced separately.
//!
//! An expression of places and axes of bodies, and of their rates, acts on these bodies; an
//! expression of joint coordinates acts along them. So when such an expression is read, a position
//! is the place of its joint, which is held fixed, plus a displacement. The axes of a body are
//! rotated directly relative to the world, whatever carries it. Its velocity, and the coordinates
//! of driven joints, are separate symbols.

use std::collections::HashSet;

use crate::errors::{Errors, every, silently};
use crate::families::LoadKind;
use crate::lower::expressions::{BodyMotion, Lowering, Value};
use crate::model::{Along, Displaced, Form, Frame, State, TreeJoint, Turns, Variable, Vector};
use crate::symbolic::{Components, Id, Stage};

use crate::syntax::Description;

use super::reading::body::Draft;
use super::reading::names::for_copy;
use super::reading::reader::Reader;

/// What replaces the motion of bodies and joints.
#[derive(Default)]
struct Apart {
    bodies: Vec<Displaced>,
    along: Vec<Along>,
    stands_for: Vec<(Id, Id)>,
}

impl Reader<'_> {
    /// Reads scalars with each body displaced separately. `read` gets the symbols of all rates.
    pub fn apart(
        &mut self,
        drafts: &mut [Draft<'_>],
        joints: &[TreeJoint],
        read: impl FnOnce(&mut Self, &mut [Draft<'_>], &[Id]) -> Option<Vec<Id>>,
    ) -> Option<Form> {
        let states: Vec<_> = drafts.iter().map(|draft| draft.state).collect();
        let scopes: Vec<_> = drafts.iter().map(|draft| draft.scope.values()).collect();
        let (scope, known) = (self.scope.values(), self.members.moving());
        let carriers: Vec<Frame> = drafts
            .iter()
            .map(|draft| self.work.carrier(draft.frame))
            .collect();
        let apart = self.displace(drafts, joints);
        let of_bodies = apart.bodies.iter().flat_map(Displaced::rates);
        let rates: Vec<Id> = of_bodies
            .chain(apart.along.iter().map(|one| one.rate))
            .collect();
        let bodies = apart.bodies.iter().map(|displaced| displaced.body);
        self.work.turns = Some(Turns::of_bodies(self.motion.axes(), bodies));
        // errors in these points are already reported
        silently(|errors| self.late_points(drafts, errors));
        let values = read(self, drafts, &rates);
        let turns = self.work.turns.take()?;
        for (draft, ((state, scope), carrier)) in drafts
            .iter_mut()
            .zip(states.into_iter().zip(scopes).zip(carriers))
        {
            draft.state = state;
            draft.scope.restore(scope);
            self.work.set_carrier(draft.frame, carrier);
        }
        self.scope.restore(scope);
        self.members.restore(known);
        let mut form = Form {
            values: values?,
            charges: Vec::new(),
            turns: turns.list,
            bodies: apart.bodies,
            along: apart.along,
            stands_for: apart.stands_for,
        };
        self.tell_rates(&mut form, drafts, joints);
        Some(form)
    }

    /// Reads scalars written outside the bodies and inside each of them, with their locals apart.
    pub fn each_apart(
        &mut self,
        drafts: &mut [Draft<'_>],
        errors: &mut Errors,
        read: impl Fn(&mut Lowering<'_>, &Description) -> Option<Vec<Id>>,
    ) -> Option<Vec<Id>> {
        let top = &self.system.top;
        let read = |lowering: &mut Lowering<'_>, description: &Description| {
            lowering.locals_apart(description);
            read(lowering, description)
        };
        let mut all = vec![self.at_top(errors, |lowering| read(lowering, top))];
        let mut wrong = HashSet::new();
        for (number, draft) in drafts.iter_mut().enumerate() {
            for local in &top.locals {
                let name = local.name.to_string();
                draft.scope.redefine(&name, self.scope.peek(&name));
            }
            let (body, first) = (draft.description, self.system.firsts[number]);
            all.push(for_copy(first, number, &mut wrong, errors, |errors| {
                self.in_body(draft, errors, |lowering, _| read(lowering, body))
            }));
        }
        Some(every(all)?.concat())
    }

    /// Adds the meanings of velocity symbols, if the expressions contain any.
    fn tell_rates(&mut self, form: &mut Form, drafts: &[Draft<'_>], joints: &[TreeJoint]) {
        let turned = form.turns.iter().flat_map(|turn| turn.vector);
        let roots: Vec<Id> = form.values.iter().copied().chain(turned).collect();
        for (joint, body) in joints.iter().zip(&form.bodies) {
            let graph = &self.work.graph;
            let symbols: Vec<Id> = body.rates().filter(|id| !graph.is_zero(*id)).collect();
            let Some(state) = drafts[joint.carried].state else {
                continue;
            };
            if graph.depends_on(&roots, |id| symbols.contains(&id)) {
                let velocity = self.velocity_at(&state, joint.pin);
                let velocity = self.work.components(velocity, Frame::WORLD);
                let rates = body
                    .velocity
                    .into_iter()
                    .chain(body.angular_velocity)
                    .zip(velocity.into_iter().chain(state.angular_velocity));
                let rates = rates.filter(|(symbol, _)| symbols.contains(symbol));
                form.stands_for.extend(rates);
            }
        }
    }

    /// The velocity of a point of a body at this offset from its G.
    fn velocity_at(&mut self, state: &State, offset: Components) -> Vector {
        let swept = self.work.graph.cross(state.angular_velocity, offset);
        let swept = self.work.vector(state.body, swept);
        self.work.add(state.velocity, swept)
    }

    /// Gives each body a separate place and velocity, and axes that are rotated relative to the
    /// world.
    fn displace(&mut self, drafts: &mut [Draft<'_>], joints: &[TreeJoint]) -> Apart {
        let copies = self.work.copied_frames();
        let mut apart = Apart::default();
        let held = self.held_coordinates(joints);
        let symbols = held.iter().map(|(place, held)| (*held, *place));
        apart.stands_for.extend(symbols);
        let kinds = [LoadKind::Force, LoadKind::Moment];
        let [axes, turning] = kinds.map(|kind| kind.axes(self.system.is_planar));
        for joint in joints {
            let draft = &mut drafts[joint.carried];
            let Some(state) = &mut draft.state else {
                continue;
            };
            let displacement = self.work.free_symbols(axes.clone());
            let velocity = self.work.free_symbols(axes.clone());
            let angular_velocity = self.work.free_symbols(turning.clone());
            let zero = self.work.graph.zero();
            apart
                .stands_for
                .extend(displacement.map(|symbol| (symbol, zero)));
            // from G to the point that the joint holds
            let pin = self.work.vector(draft.frame, joint.pin);
            let at_joint = self.work.add(state.position, pin);
            let mut position = self.work.vector(Frame::WORLD, displacement);
            for (frame, part) in self.work.parts(at_joint).to_vec() {
                let part = self.work.graph.replaced(part, &held);
                let part = self.work.vector(copies[frame.index()], part);
                position = self.work.add(position, part);
            }
            let back = self.work.negate(pin);
            state.position = self.work.add(position, back);
            state.angular_velocity = angular_velocity;
            state.velocity = self.work.vector(Frame::WORLD, velocity);
            let moved = *state;
            let back = self.work.graph.negate_vector(joint.pin);
            let velocity_of_center = self.velocity_at(&moved, back);
            let state = State {
                velocity: velocity_of_center,
                ..moved
            };
            draft.state = Some(state);
            let angle = self.told_apart(joint, draft, &state, &mut apart);
            apart.bodies.push(Displaced {
                body: draft.frame,
                displacement,
                velocity,
                angular_velocity,
                angle,
                has_own_attitude: joint.kind.has_attitude(),
            });
        }
        for (number, joint) in joints.iter().enumerate() {
            self.coordinates_apart(number, joint, &mut apart);
        }
        for draft in drafts {
            self.work.set_carrier(draft.frame, Frame::WORLD);
        }
        apart
    }

    /// The coordinates of joints, each with the symbol that replaces it.
    fn held_coordinates(&mut self, joints: &[TreeJoint]) -> Vec<(Id, Id)> {
        // a prescribed coordinate is not a symbol: it is a function of time, or a number that may
        // also occur elsewhere
        let open = joints.iter().filter(|joint| !joint.is_driven());
        let places = open.flat_map(|joint| &joint.coordinates.0);
        let places =
            places.filter(|one| matches!(one.variable, Variable::Position | Variable::Angle));
        places
            .map(|place| (place.id, self.work.graph.symbol(Stage::State)))
            .collect()
    }

    /// Registers the new motion of a body. In the plane, returns the symbol of its angle.
    fn told_apart(
        &mut self,
        joint: &TreeJoint,
        draft: &mut Draft<'_>,
        state: &State,
        apart: &mut Apart,
    ) -> Option<Id> {
        let body = &mut self.members.bodies[joint.carried];
        body.motion = Some(BodyMotion {
            position: state.position,
            velocity: state.velocity,
            acceleration: state.acceleration,
            angular_velocity: state.angular_velocity,
            angular_acceleration: state.angular_acceleration,
        });
        let mut told = self.values_of_motion(state);
        let angle = match draft.scope.peek("attitude") {
            Some(Value::Scalar(real, dimension)) if self.system.is_planar => {
                let angle = self.work.graph.symbol(Stage::State);
                apart.stands_for.push((angle, real));
                let value = Value::Scalar(angle, dimension);
                told.push(("attitude", value));
                draft.scope.redefine("attitude", Some(value));
                Some(angle)
            }
            _ => None,
        };
        let body = &mut self.members.bodies[joint.carried];
        for (name, value) in &mut body.values {
            if let Some((_, new)) = told.iter().find(|(word, _)| word == name) {
                *value = *new;
            }
        }
        if joint.kind.is_free() {
            let of_joint = self.members.joints.iter_mut();
            for known in of_joint.filter(|known| joint.name == known.name.as_str()) {
                for (name, value) in &mut known.values {
                    let word = if *name == "angle" { "attitude" } else { name };
                    if let Some((_, new)) = told.iter().find(|(told, _)| *told == word) {
                        *value = *new;
                    }
                }
            }
        }
        angle
    }

    /// Replaces the coordinates of a joint between bodies; those of a driven joint by separate
    /// symbols.
    fn coordinates_apart(&mut self, number: usize, joint: &TreeJoint, apart: &mut Apart) {
        if joint.kind.is_free() {
            return;
        }
        let mut coordinates = joint.coordinates.clone();
        if joint.is_driven() {
            for one in &mut coordinates.0 {
                let symbol = self.work.graph.symbol(Stage::State);
                apart.stands_for.push((symbol, one.id));
                one.id = symbol;
            }
            let values = self.values_of_joint(joint, &coordinates);
            let known = self.members.joints.iter_mut();
            for known in known.filter(|known| joint.name == known.name.as_str()) {
                known.values.clone_from(&values);
            }
        }
        let freedoms = joint.kind.freedoms(self.system.is_planar);
        for (freedom, (variable, part)) in freedoms.into_iter().enumerate() {
            let place = match variable {
                Variable::Velocity => Variable::Position,
                _ => Variable::Angle,
            };
            let Some(rate) = coordinates.get(variable, part) else {
                continue;
            };
            apart.along.push(Along {
                joint: number,
                freedom,
                place: coordinates.get(place, part),
                rate,
            });
        }
    }
}
