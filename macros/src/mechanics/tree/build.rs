//! From the bodies and joints of a system to the links of a tree.

use crate::families::LoadKind;
use crate::mechanics::balances::{moments_about, resultant};
use crate::model::{
    AXES, Load, Member, Part, Point, Rates, System, TreeJoint, Variable, Workspace,
};
use crate::symbolic::{Components, Function, Id};

use super::link::{Freedom, Link, Tree};
use super::properties::Properties;
use super::spatial::{SpatialInertia, SpatialVector};
use super::turning::Turning;

/// Rotations about the axes, in names.
const TURNS: [&str; 3] = ["turn_x", "turn_y", "turn_z"];

/// A tree, and the links of each joint, the last of which is the body.
pub struct Built {
    pub tree: Tree,
    pub links: Vec<core::ops::Range<usize>>,
}

impl Built {
    /// The link of a body.
    pub fn body(&self, body: usize) -> usize {
        self.links[body].end - 1
    }
}

/// Makes links for all bodies. The origin of each link is at the joint that carries it.
pub fn build(system: &System, work: &mut Workspace) -> Built {
    let mut built = Built {
        tree: Tree {
            links: Vec::new(),
            gravity: system.gravity,
        },
        links: Vec::new(),
    };
    for (body, joint) in system.bodies.iter().zip(&system.joints) {
        let first = built.tree.links.len();
        // from the joint that carries the carrier to this joint
        let place = match joint.carrier {
            None => joint.place,
            Some(carrier) => {
                let pin = system.joints[carrier].pin;
                work.graph.subtract_vectors(joint.place, pin)
            }
        };
        let carrier = joint.carrier.map(|carrier| built.body(carrier));
        let mut making = Making {
            work,
            joint,
            links: &mut built.tree.links,
            carrier,
            place,
            name: body.name.to_string(),
        };
        making.joint(system.is_planar);
        let (force, moment) = wrench(work, body, &body.loads, joint.pin);
        let center = work.graph.negate_vector(joint.pin);
        let rows = body.inertia.rows(&mut work.graph);
        let properties = Properties::of_body(&mut work.graph, body.mass, center, &rows);
        if let Some(link) = built.tree.links.last_mut() {
            (link.properties, link.force, link.moment) = (properties, force, moment);
        }
        built.links.push(first..built.tree.links.len());
    }
    built
}

/// The sum of loads on a body, about a point of it, in its axes.
pub fn wrench<'l>(
    work: &mut Workspace,
    body: &Member,
    loads: impl IntoIterator<Item = &'l Load> + Clone,
    pin: Components,
) -> (Components, Components) {
    let frame = body.state.body;
    let force = resultant(work, loads.clone());
    let moments = moments_about(&body.state, work, loads, Point::Fixed(frame, pin));
    let moment = work.sum(moments);
    let [force, moment] = [force, moment].map(|vector| {
        let components = work.components(vector, frame);
        work.graph.quantities(components)
    });
    (force, moment)
}

/// The links of one joint while they are made.
struct Making<'a> {
    work: &'a mut Workspace,
    joint: &'a TreeJoint,
    links: &'a mut Vec<Link>,
    carrier: Option<usize>,
    place: Components,
    name: String,
}

impl Making<'_> {
    fn joint(&mut self, is_planar: bool) {
        let joint = self.joint;
        if let Some(turning) = self.turned() {
            self.link(turning, Vec::new());
        }
        let (mut next, rates) = (0, &joint.coordinates);
        for (part, coordinate) in joint.kind.numbered() {
            let count = match part {
                Part::Ball => 3,
                Part::Free if is_planar => 3,
                Part::Free => 6,
                Part::Turn(_) | Part::Slide(_) | Part::Screw => 1,
            };
            let first = next;
            next += count;
            match part {
                Part::Turn(number) => {
                    let direction = joint.directions[number];
                    let twist = SpatialVector::about(&self.work.graph, direction);
                    self.hinge(direction, twist, coordinate, first);
                }
                Part::Slide(number) => self.slide(joint.directions[number], coordinate, first),
                Part::Screw => self.screw(joint.directions[0], coordinate, first),
                Part::Ball => self.ball(rates, first),
                Part::Free => self.float(rates, first, is_planar),
            }
        }
        if joint.kind.parts.is_empty() {
            self.link(Turning::Parallel, Vec::new());
        }
    }

    /// All rotations at zero coordinates, combined into one.
    fn turned(&mut self) -> Option<Turning> {
        let graph = &mut self.work.graph;
        let turns = self.joint.turned.iter().map(|(axis, angle)| {
            let cosine = graph.apply(Function::Cos, &[*angle]);
            let sine = graph.apply(Function::Sin, &[*angle]);
            Turning::about(graph, *axis, cosine, sine).as_matrix(graph)
        });
        let turns: Vec<Turning> = turns.collect();
        let mut turns = turns.into_iter();
        let first = turns.next()?;
        Some(turns.fold(first, |whole, then| whole.after(graph, then)))
    }

    /// The component of a variable, for the coordinate with this index.
    fn get(&self, variable: Variable, coordinate: usize) -> Id {
        let known = self.joint.coordinates.get(variable, coordinate);
        known.unwrap_or(self.work.graph.zero())
    }

    fn slide(&mut self, direction: Components, coordinate: usize, number: usize) {
        let distance = self.get(Variable::Position, coordinate);
        let rate = self.get(Variable::Velocity, coordinate);
        let graph = &mut self.work.graph;
        let step = graph.scale_vector(distance, direction);
        self.place = graph.add_vectors(self.place, step);
        let twist = SpatialVector::along(graph, direction);
        let freedom = self.freedom(twist, rate, number, "slide");
        self.link(Turning::Parallel, vec![freedom]);
    }

    fn screw(&mut self, direction: Components, coordinate: usize, number: usize) {
        let angle = self.get(Variable::Angle, coordinate);
        let graph = &mut self.work.graph;
        let pitch = self.joint.pitch.unwrap_or(graph.zero());
        let along = graph.scale_vector(pitch, direction);
        let step = graph.scale_vector(angle, along);
        self.place = graph.add_vectors(self.place, step);
        let twist = SpatialVector {
            angular: direction,
            linear: along,
        };
        self.hinge(direction, twist, coordinate, number);
    }

    fn ball(&mut self, rates: &Rates, first: usize) {
        let units = self.work.graph.unit_vectors();
        let zero = self.work.graph.zero();
        let get = |variable: Variable, part: usize| rates.get(variable, part).unwrap_or(zero);
        let quaternion = [0, 1, 2, 3].map(|part| get(Variable::Quaternion, part));
        let turning = quaternion_turning(self.work, quaternion);
        let rates = [0, 1, 2].map(|axis| get(Variable::AngularVelocity, axis));
        let freedoms = (0..3).map(|axis| {
            let twist = SpatialVector::about(&self.work.graph, units[axis]);
            self.freedom(twist, rates[axis], first + axis, TURNS[axis])
        });
        let freedoms = freedoms.collect();
        self.link(turning, freedoms);
    }

    /// Adds a link that moves in all directions; those along the axes come first.
    fn float(&mut self, rates: &Rates, first: usize, is_planar: bool) {
        let units = self.work.graph.unit_vectors();
        let zero = self.work.graph.zero();
        let get = |variable: Variable, part: usize| rates.get(variable, part).unwrap_or(zero);
        let linear = if is_planar { 2 } else { 3 };
        let mut freedoms: Vec<Freedom> = (0..linear)
            .map(|axis| {
                let twist = SpatialVector::along(&self.work.graph, units[axis]);
                let rate = get(Variable::Velocity, axis);
                self.freedom(twist, rate, first + axis, AXES[axis])
            })
            .collect();
        for (part, axis) in LoadKind::Moment.axes(is_planar).enumerate() {
            let twist = SpatialVector::about(&self.work.graph, units[axis]);
            let rate = get(Variable::AngularVelocity, part);
            let along = if is_planar { "turn" } else { TURNS[axis] };
            freedoms.push(self.freedom(twist, rate, first + linear + part, along));
        }
        let turning = if is_planar {
            Turning::by_angle(&mut self.work.graph, 2, get(Variable::Angle, 0))
        } else {
            let quaternion = [0, 1, 2, 3].map(|part| get(Variable::Quaternion, part));
            quaternion_turning(self.work, quaternion)
        };
        let index = self.link(turning, freedoms);
        (self.links[index].is_free, self.links[index].falls) = (true, true);
    }

    /// A link that rotates about a direction.
    fn hinge(
        &mut self,
        direction: Components,
        twist: SpatialVector,
        coordinate: usize,
        number: usize,
    ) {
        let angle = self.get(Variable::Angle, coordinate);
        let rate = self.get(Variable::AngularVelocity, coordinate);
        let graph = &mut self.work.graph;
        let cosine = graph.apply(Function::Cos, &[angle]);
        let sine = graph.apply(Function::Sin, &[angle]);
        let turning = Turning::about(graph, direction, cosine, sine);
        let about = match turning {
            Turning::About { axis, .. } => Some(graph.multiply(direction[axis], angle)),
            Turning::Parallel | Turning::By(_) => None,
        };
        let freedom = self.freedom(twist, rate, number, "turn");
        let index = self.link(turning, vec![freedom]);
        self.links[index].angle = about;
    }

    /// The joint coordinate with this index. `along` tells it from others of the joint.
    fn freedom(&self, twist: SpatialVector, rate: Id, number: usize, along: &str) -> Freedom {
        let joint = self.joint.name.to_string();
        let is_alone = self.joint.drives.len() == 1;
        Freedom {
            twist,
            rate,
            armature: self
                .joint
                .armature
                .unwrap_or_else(|| self.work.graph.zero()),
            drive: self.joint.drives[number],
            given: self.joint.given[number],
            name: if is_alone {
                joint.clone()
            } else {
                format!("{joint}_{along}")
            },
            joint,
        }
    }

    /// Adds a massless link, from which the joint continues.
    fn link(&mut self, turning: Turning, freedoms: Vec<Freedom>) -> usize {
        if let Turning::By(rows) = turning {
            let name = format!("rotation_{}", self.name);
            self.work.labels.matrix(&name, &rows);
        }
        let graph = &self.work.graph;
        let zeros = graph.zeros();
        self.links.push(Link {
            name: self.name.clone(),
            carrier: self.carrier,
            place: self.place,
            turning,
            angle: None,
            freedoms,
            is_free: false,
            falls: false,
            properties: Properties::none(graph),
            added: SpatialInertia::none(graph),
            force: zeros,
            moment: zeros,
        });
        let index = self.links.len() - 1;
        (self.carrier, self.place) = (Some(index), zeros);
        index
    }
}

fn quaternion_turning(work: &mut Workspace, [w, x, y, z]: [Id; 4]) -> Turning {
    Turning::quaternion(&mut work.graph, w, [x, y, z])
}
