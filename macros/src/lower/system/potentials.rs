//! Potentials of a system, read with each body displaced by itself.
//!
//! What is written in the places and axes of bodies acts on these bodies; what is written in the
//! coordinates of joints, along them. So a position is read as where its joint is, which is held, and
//! a displacement; and the axes of a body as turned against the world at once, whatever carries it.

use std::collections::{HashMap, HashSet};

use crate::errors::Errors;
use crate::lower::expressions::Value;
use crate::model::{
    Coordinate, Dimension, Displaced, Form, Frame, Potential, Potentials, TreeJoint, Turns,
    Variable, Vector,
};
use crate::symbolic::{Components, Id, Stage};
use crate::syntax::Definition;

use super::reading::body::Draft;
use super::reading::names::for_copy;
use super::reading::reader::Reader;

/// What is put in the place of bodies that move.
struct Apart {
    bodies: Vec<Displaced>,
    stands_for: Vec<(Id, Id)>,
}

impl Reader<'_> {
    /// Reads the potentials of the system and of its bodies.
    pub fn potentials(
        &mut self,
        drafts: &mut [Draft<'_>],
        joints: &[TreeJoint],
        errors: &mut Errors,
    ) -> Option<Potentials> {
        let of_bodies = drafts
            .iter()
            .flat_map(|draft| &draft.description.potentials);
        let written = self.system.top.potentials.iter().chain(of_bodies);
        let list: Vec<Potential> = written
            .map(|potential| Potential {
                name: potential.name.clone(),
                place: 0,
                charges: None,
            })
            .collect();
        let mut forms = Vec::new();
        let is_known = self.members.bodies.iter().all(|body| body.motion.is_some());
        if !list.is_empty() && is_known {
            forms.push(self.form(drafts, joints, errors)?);
        }
        Some(Potentials { list, forms })
    }

    fn form(
        &mut self,
        drafts: &mut [Draft<'_>],
        joints: &[TreeJoint],
        errors: &mut Errors,
    ) -> Option<Form> {
        // what is prescribed is a function of time, or a number that stands elsewhere too
        let moving: Vec<&Coordinate> = joints
            .iter()
            .filter(|joint| !joint.is_driven())
            .flat_map(|joint| &joint.coordinates.0)
            .collect();
        let of = |variables: [Variable; 2]| {
            let found = moving
                .iter()
                .filter(|one| variables.contains(&one.variable));
            found.map(|one| one.id).collect::<Vec<Id>>()
        };
        let rates = of([Variable::Velocity, Variable::AngularVelocity]);
        let places = of([Variable::Position, Variable::Angle]);
        let states: Vec<_> = drafts.iter().map(|draft| draft.state).collect();
        let scopes: Vec<_> = drafts.iter().map(|draft| draft.scope.values()).collect();
        let (scope, known) = (self.scope.values(), self.members.moving());
        let carriers: Vec<Frame> = drafts
            .iter()
            .map(|draft| self.work.carrier(draft.frame))
            .collect();
        let apart = self.displace(drafts, joints, &places);
        let bodies = apart.bodies.iter().map(|displaced| displaced.body);
        self.work.turns = Some(Turns::of_bodies(self.motion.axes(), bodies));
        let energies = self.energies(drafts, &rates, errors);
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
        let free = joints.iter().filter(|joint| joint.kind.is_free());
        let free: HashSet<Id> = free
            .flat_map(|joint| &joint.coordinates.0)
            .map(|one| one.id)
            .collect();
        let coordinates = places.into_iter().filter(|place| !free.contains(place));
        Some(Form {
            energies: energies?,
            charges: Vec::new(),
            turns: turns.list,
            bodies: apart.bodies,
            coordinates: coordinates.collect(),
            stands_for: apart.stands_for,
        })
    }

    /// Gives each body a place of its own, and axes that are turned against those of the world.
    fn displace(&mut self, drafts: &mut [Draft<'_>], joints: &[TreeJoint], places: &[Id]) -> Apart {
        let copies = self.work.copied_frames();
        let graph = &mut self.work.graph;
        let held: HashMap<Id, Id> = places
            .iter()
            .map(|place| (*place, graph.symbol(Stage::State)))
            .collect();
        let mut apart = Apart {
            bodies: Vec::new(),
            stands_for: held.iter().map(|(place, held)| (*held, *place)).collect(),
        };
        for joint in joints {
            let draft = &mut drafts[joint.carried];
            let Some(state) = &mut draft.state else {
                continue;
            };
            let displacement = self.displacement();
            let zero = self.work.graph.zero();
            apart
                .stands_for
                .extend(displacement.map(|symbol| (symbol, zero)));
            // from G to the point that the joint holds
            let pin = self.work.vector(draft.frame, joint.pin);
            let at_joint = self.work.add(state.position, pin);
            let mut position = self.work.vector(Frame::WORLD, displacement);
            for (frame, part) in self.work.parts(at_joint).to_vec() {
                let part = self
                    .work
                    .graph
                    .substitute(&part, |id| held.get(&id).copied());
                let part = [part[0], part[1], part[2]];
                let part = self.work.vector(copies[frame.index()], part);
                position = self.work.add(position, part);
            }
            let back = self.work.negate(pin);
            state.position = self.work.add(position, back);
            let position = state.position;
            let angle = self.told_apart(joint, draft, position, &mut apart);
            apart.bodies.push(Displaced {
                body: draft.frame,
                displacement,
                angle,
                has_own_attitude: joint.kind.has_attitude(),
            });
        }
        for draft in drafts {
            self.work.set_carrier(draft.frame, Frame::WORLD);
        }
        apart
    }

    /// The symbols of a displacement.
    fn displacement(&mut self) -> Components {
        let axes = self.motion.axes();
        let graph = &mut self.work.graph;
        [0, 1, 2].map(|axis| {
            if axis < axes {
                graph.symbol(Stage::State)
            } else {
                graph.zero()
            }
        })
    }

    /// Tells all of where a body is now; returns what its angle is told by, in the plane.
    fn told_apart(
        &mut self,
        joint: &TreeJoint,
        draft: &mut Draft<'_>,
        position: Vector,
        apart: &mut Apart,
    ) -> Option<Id> {
        let place = Value::Vector(position, Dimension::LENGTH);
        let body = &mut self.members.bodies[joint.carried];
        if let Some(motion) = &mut body.motion {
            motion.position = position;
        }
        let mut told = vec![("position", place)];
        let attitude = draft.scope.peek("attitude");
        let angle = match attitude {
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

    /// The energies, as functions of what is kept apart.
    fn energies(
        &mut self,
        drafts: &mut [Draft<'_>],
        rates: &[Id],
        errors: &mut Errors,
    ) -> Option<Vec<Id>> {
        let top = &self.system.top;
        let mut energies: Vec<Option<Id>> = self.at_top(errors, |lowering| {
            lowering.locals_apart(top);
            let read = |potential: &Definition| lowering.potential(potential.value.as_ref(), rates);
            top.potentials.iter().map(read).collect()
        });
        let mut wrong = HashSet::new();
        for (number, draft) in drafts.iter_mut().enumerate() {
            for local in &top.locals {
                let name = local.name.to_string();
                draft.scope.redefine(&name, self.scope.peek(&name));
            }
            let body = draft.description;
            let first = self.system.firsts[number];
            let of_body = for_copy(first, number, &mut wrong, errors, |errors| {
                self.in_body(draft, errors, |lowering, _| {
                    lowering.locals_apart(body);
                    let read = |potential: &Definition| {
                        lowering.potential(potential.value.as_ref(), rates)
                    };
                    body.potentials.iter().map(read).collect::<Vec<_>>()
                })
            });
            energies.extend(of_body);
        }
        energies.into_iter().collect()
    }
}
