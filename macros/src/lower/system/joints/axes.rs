//! The axes of joints, and the rotation of the carried body.

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::model::{Axes, Dimension, Drawn, Frame, JointKind};
use crate::symbolic::{Comparison, Components, Id};
use crate::syntax::Expression;

use super::drawing::in_drawing;
use crate::lower::inertia::rotation;
use crate::lower::system::reading::reader::{Reader, still};

/// An axis, and an angle about it.
type Turn = (Components, Id);

impl Reader<'_> {
    /// The directions of the parts of a joint between these bodies. The first may be the ground.
    pub fn directions(
        &mut self,
        between: (Option<usize>, usize),
        kind: &JointKind,
        arguments: &[Expression],
        turned: &[Turn],
        errors: &mut Errors,
    ) -> Option<Vec<Components>> {
        let written = &arguments[arguments.len().min(2)..][..kind.directions()];
        let directions: Vec<Option<Components>> = written
            .iter()
            .map(|direction| self.direction(between, direction, turned, errors))
            .collect();
        if let [Some(first), Some(second)] = *directions {
            let across = self.work.graph.cross(first, second);
            if self.work.graph.is_zero_vector(&across) {
                errors.push(
                    written[1].extent,
                    "the axes of a universal joint are not parallel: parallel axes give only one degree of freedom",
                );
                return None;
            }
        }
        let directions: Vec<Components> = directions.into_iter().collect::<Option<_>>()?;
        match (kind.axes, directions.as_slice()) {
            (Axes::Own, _) => Some(self.work.graph.unit_vectors().to_vec()),
            (Axes::Normal, [normal]) => {
                let [along, across] = self.across(*normal);
                Some(vec![*normal, along, across])
            }
            (Axes::InThePlane, [along]) => Some(vec![*along, self.work.graph.unit_vectors()[2]]),
            _ => Some(directions),
        }
    }

    /// The pitch of a screw. The inner `None` stands for any other joint.
    #[allow(clippy::option_option, reason = "outer: reported; inner: not a screw")]
    pub fn pitch(
        &mut self,
        kind: &JointKind,
        arguments: &[Expression],
        errors: &mut Errors,
    ) -> Option<Option<Id>> {
        if !kind.is_screw() {
            return Some(None);
        }
        let written = &arguments[3];
        self.at_top(errors, |lowering| {
            let what = "the pitch of a screw, meters per radian,";
            let pitch = lowering.scalar(written, Dimension::LENGTH, what)?;
            lowering.check_early(written, &[pitch], "a pitch is fixed")?;
            Some(Some(pitch))
        })
    }

    /// A unit vector in the axes of the carried body, which at zero coordinates are rotated by
    /// `turned` from those of the carrier.
    fn direction(
        &mut self,
        between: (Option<usize>, usize),
        written: &Expression,
        turned: &[Turn],
        errors: &mut Errors,
    ) -> Option<Components> {
        let (frame, direction) = self.framed_direction(between.1, written, errors)?;
        let axes = |body: Option<usize>| match body {
            Some(body) => self.members.bodies[body].frame,
            None => Frame::WORLD,
        };
        let (carrier, carried) = (axes(between.0), axes(Some(between.1)));
        if self.system.is_drawn() || frame == carried {
            return Some(direction);
        }
        if frame != carrier {
            let name = |body: usize| &self.members.bodies[body].name;
            let of_carrier = match between.0 {
                Some(body) => format!("{}.body", name(body)),
                None => "world".to_owned(),
            };
            let message = format!(
                "a direction of a joint is in the axes of what it joins: write `body(..)` for those of \
                 `{}`, or `{of_carrier}(..)`",
                name(between.1)
            );
            return errors.report(written.extent, message);
        }
        let graph = &mut self.work.graph;
        let back = turned.iter().fold(direction, |direction, (axis, angle)| {
            let angle = graph.negate(*angle);
            let rows = rotation(graph, *axis, angle);
            rows.map(|row| graph.dot(row, direction))
        });
        Some(back)
    }

    /// A unit vector as written, and its axes.
    fn framed_direction(
        &mut self,
        body: usize,
        written: &Expression,
        errors: &mut Errors,
    ) -> Option<(Frame, Components)> {
        let frame = self.members.bodies[body].frame;
        let defaults = self.defaults.clone();
        let mut scope = self.scope.clone();
        let mut state = still(frame, self.time);
        let mut lowering = crate::lower::expressions::Lowering {
            work: &mut self.work,
            scope: &mut scope,
            errors,
            motion: self.motion,
            state: &mut state,
            reactions: Vec::new(),
            is_constrained: false,
            composed: None,
            has_parts: false,
            drawn: Drawn::Alone,
            members: &self.members,
            is_whole: false,
        };
        let found = if self.system.is_drawn() {
            lowering.framed_direction(&in_drawing(written), &defaults)
        } else {
            lowering.framed_direction(written, &defaults)
        };
        self.scope = scope;
        found
    }

    /// All `.turned(axis, angle)`, each in the axes that the preceding ones have rotated.
    pub fn turned(
        &mut self,
        between: (Option<usize>, usize),
        methods: &[(&Ident, &[Expression])],
        errors: &mut Errors,
    ) -> Option<Vec<Turn>> {
        let mut turned = Some(Vec::new());
        let may_turn = !self.system.is_drawn();
        // methods are listed from the outermost, which is written last
        let others = methods.iter().rev();
        let others = others.filter(|(method, _)| *method != "driven" && *method != "armature");
        for (method, arguments) in others {
            let found = match *arguments {
                [axis, angle] if *method == "turned" && may_turn && !self.system.is_planar => {
                    let before = turned.as_deref().unwrap_or_default();
                    let axis = self.direction(between, axis, before, errors);
                    let angle = self.fixed_angle(angle, errors);
                    axis.zip(angle)
                }
                [angle] if *method == "turned" && may_turn && self.system.is_planar => {
                    let axis = self.work.graph.unit_vectors()[2];
                    let angle = self.fixed_angle(angle, errors);
                    angle.map(|angle| (axis, angle))
                }
                _ => {
                    errors.push(method.span(), self.why_not_behind(method));
                    None
                }
            };
            match (found, &mut turned) {
                (Some((axis, angle)), Some(all)) => match all.last_mut() {
                    // exact, before there are sines
                    Some((same, sum)) if *same == axis => {
                        *sum = self.work.graph.add(*sum, angle);
                    }
                    _ => all.push((axis, angle)),
                },
                _ => turned = None,
            }
        }
        turned
    }

    /// The error for a method after a joint.
    fn why_not_behind(&self, method: &Ident) -> String {
        let word = method.to_string();
        let message = match (word.as_str(), self.system.is_drawn()) {
            ("turned", true) => {
                "in a drawing all bodies are as they are drawn: leave `.turned(..)` out"
            }
            ("turned", false) => "write `.turned(axis, angle)`, in the plane `.turned(angle)`",
            ("at", true) => "a joint is in one place: leave this out",
            ("at", false) => {
                "`.at(..)` places a joint in a drawing: write `drawing: zero_pose`, or points of bodies"
            }
            ("damping" | "damper" | "friction" | "spring" | "stiffness", _) => {
                return format!(
                    "a joint has no `{word}`: write a drive, such as `damper = (-c * elbow.angular_velocity).on(elbow)` \
                     in `drives`, or the energy of a spring, such as `spring = 0.5 * k * elbow.angle.powi(2)` in \
                     `potentials`"
                );
            }
            ("limits" | "limit" | "range", _) => {
                return format!(
                    "a joint has no `{word}`: find where it ends by `.events(..)` of an integration, or write a stiff \
                     spring beyond it in `potentials`"
                );
            }
            ("locked" | "fixed", _) => {
                return format!(
                    "a joint that never moves is a `weld(P, Q)`: leave `.{word}(..)` out"
                );
            }
            (_, true) => {
                return format!(
                    "a joint of a drawing has no `{word}`: only `.at(..)`, `.driven(angle)` and `.armature(J)` may follow"
                );
            }
            (_, false) => {
                return format!(
                    "a joint has no `{word}`: only `.turned(axis, angle)`, `.driven(angle)` and `.armature(J)` may follow"
                );
            }
        };
        message.to_owned()
    }

    /// Two unit vectors that make right-handed axes with a unit vector. They are the two coordinate
    /// axes that follow the one nearest to its default (the first in a tie), rotated by the smallest
    /// rotation that takes the nearest axis to the vector. There is none if a parameter reverses the
    /// vector; then they are not finite.
    pub fn across(&mut self, normal: Components) -> [Components; 2] {
        let graph = &mut self.work.graph;
        let known = graph.substitute(&normal, |id| self.defaults.get(&id).copied());
        let sizes = graph.evaluate(&known, |_| 0.0);
        let nearer = |a: usize, b: usize| sizes[b].abs() > sizes[a].abs() * (1.0 + 1e-12);
        let nearest = (1..3).fold(0, |best, axis| if nearer(best, axis) { axis } else { best });
        let units = graph.unit_vectors();
        let [first, mut second] = [1, 2].map(|step| units[(nearest + step) % 3]);
        let mut axis = units[nearest];
        if sizes[nearest] < 0.0 {
            (axis, second) = (graph.negate_vector(axis), graph.negate_vector(second));
        }
        // v - (v . n) (e + a / (1 + e . n)), for v perpendicular to e, where a is the part of n across e;
        // if n is nearly opposite to e, 1 + e . n cancels, and is a^2 / (1 - e . n)
        let (one, zero) = (graph.one(), graph.zero());
        let along = graph.dot(axis, normal);
        let [more, less] = [graph.add(one, along), graph.subtract(one, along)];
        let leans = [first, second].map(|v| graph.dot(v, normal));
        let squares = graph.inner(leans, leans);
        let is_near = graph.compare(Comparison::LessOrEqual, zero, along);
        let opposite = graph.divide(squares, less);
        let more = graph.select(is_near, more, opposite);
        let parts = [(first, leans[0]), (second, leans[1])];
        let [one, other] = parts.map(|(v, lean)| graph.scale_vector(lean, v));
        let across = graph.add_vectors(one, other);
        parts.map(|(v, lean)| {
            let share = graph.divide(lean, more);
            let along = graph.scale_vector(lean, axis);
            let across = graph.scale_vector(share, across);
            let less = graph.add_vectors(along, across);
            graph.subtract_vectors(v, less)
        })
    }

    fn fixed_angle(&mut self, written: &Expression, errors: &mut Errors) -> Option<Id> {
        self.at_top(errors, |lowering| {
            let angle = lowering.scalar(written, Dimension::NONE, "an angle")?;
            lowering.check_early(written, &[angle], "how a joint is turned is fixed")?;
            Some(angle)
        })
    }
}
