//! The closed form of the motion of one joint. Its accelerations are proved to have this form.

use proc_macro2::Ident;

use crate::mechanics::closed_forms::{
    Gyrostat, Rotation, Solid, Turning, at_rest, constants, free, swing, symmetric,
};
use crate::mechanics::proofs::all_vanish;
use crate::model::{Frame, Inertia, System, TreeJoint, Variable, Workspace};
use crate::symbolic::{Components, Id};

use super::carried::Carried;
use crate::mechanics::system::equations::SystemEquations;
use crate::mechanics::system::rates::velocities;

/// The motion of a joint in closed form.
pub enum Course {
    /// All coordinates have constant accelerations.
    Uniform(Vec<Id>),
    /// It rotates; if the joint is free, the center of mass moves on a parabola.
    Turning(Rotation, Option<Center>),
    /// It rotates on a pendulum, against the swing of the pendulum.
    Counter(Counter),
}

/// A hinge on a pendulum. The sum of its angle and that of the pendulum, about the same direction,
/// has a constant acceleration.
pub struct Counter {
    /// The name of the joint of the pendulum.
    pub swing: Ident,
    /// The rate of small oscillations of the pendulum, and the angle at which it hangs.
    pub pendulum: [Id; 2],
    /// Whether the pendulum also translates.
    pub translates: bool,
    /// Whether its axis points the opposite way.
    pub is_opposite: bool,
    /// The acceleration of the sum of both angles.
    pub acceleration: Id,
}

/// The motion of the center of mass of everything that a free joint carries.
pub struct Center {
    /// Its acceleration, which is constant, in world axes.
    pub acceleration: Components,
    /// Its offset from the G of the body, in body axes, unless it is there.
    pub offset: Option<Components>,
}

/// A joint of a system whose accelerations are known.
pub struct SolvedJoint<'a> {
    pub system: &'a System,
    pub equations: &'a SystemEquations,
    pub number: usize,
}

impl SolvedJoint<'_> {
    /// Its motion, if that has a closed form.
    pub fn course(&self, work: &mut Workspace) -> Option<Course> {
        let (joint, found) = (self.joint(), self.accelerations());
        if let Some(values) = self
            .has_no_attitude()
            .then(|| constants(work, found))
            .flatten()
        {
            return Some(Course::Uniform(values));
        }
        if let [acceleration] = found {
            let angle = joint.coordinates.get(Variable::Angle, 0)?;
            return Some(Course::Turning(swing(angle, work, *acceleration)?, None));
        }
        if joint.carrier.is_some() {
            return None;
        }
        match *found {
            [x, y, angular] if joint.kind.is_free() => self.flat(work, [x, y], angular),
            [x, y, z] if !self.has_no_attitude() => {
                Some(Course::Turning(self.rotation(work, [x, y, z])?, None))
            }
            [x, y, z, a, b, c] => {
                let rotation = self.rotation(work, [a, b, c])?;
                let center = self.center(work, [x, y, z], [a, b, c])?;
                Some(Course::Turning(rotation, Some(center)))
            }
            _ => None,
        }
    }

    /// Its motion, if it is a hinge on one of these pendulums that turns against the swing.
    pub fn counter(&self, work: &mut Workspace, courses: &[Option<Course>]) -> Option<Counter> {
        let [own] = *self.accelerations() else {
            return None;
        };
        self.joint().coordinates.get(Variable::Angle, 0)?;
        courses.iter().enumerate().find_map(|(swing, course)| {
            let Some(Course::Turning(Rotation::Pendulum { rate, hanging }, center)) = course else {
                return None;
            };
            let its = *self.equations.accelerations[swing].last()?;
            [false, true].into_iter().find_map(|is_opposite| {
                let graph = &mut work.graph;
                let total = if is_opposite {
                    graph.subtract(own, its)
                } else {
                    graph.add(own, its)
                };
                Some(Counter {
                    swing: self.system.joints[swing].name.clone(),
                    pendulum: [*rate, *hanging],
                    translates: center.is_some(),
                    is_opposite,
                    acceleration: constants(work, &[total])?[0],
                })
            })
        })
    }

    fn joint(&self) -> &TreeJoint {
        &self.system.joints[self.number]
    }

    fn accelerations(&self) -> &[Id] {
        &self.equations.accelerations[self.number]
    }

    fn has_no_attitude(&self) -> bool {
        self.joint()
            .coordinates
            .get(Variable::Quaternion, 0)
            .is_none()
    }

    fn body(&self) -> Frame {
        self.system.bodies[self.joint().carried].state.body
    }

    fn carried(&self, work: &mut Workspace) -> Carried {
        Carried::by(self.number, &self.equations.built, work)
    }

    /// The motion of a free body in the plane.
    fn flat(&self, work: &mut Workspace, [x, y]: [Id; 2], angular: Id) -> Option<Course> {
        let zero = work.graph.zero();
        let rotation = match constants(work, &[angular]) {
            Some(values) => Rotation::Uniform(values[0]),
            None => swing(
                self.joint().coordinates.get(Variable::Angle, 0)?,
                work,
                angular,
            )?,
        };
        let center = self.center(work, [x, y, zero], [zero, zero, angular])?;
        Some(Course::Turning(rotation, Some(center)))
    }

    /// The parabola of the center of mass, if it moves on one, so that `a + w' x c + w x (w x c)`
    /// is constant.
    fn center(
        &self,
        work: &mut Workspace,
        linear: Components,
        angular: Components,
    ) -> Option<Center> {
        let offset = self.carried(work).center;
        let w = self.angular_velocity(work);
        let graph = &mut work.graph;
        let (driven, swept) = (graph.cross(angular, offset), graph.cross(w, offset));
        let drawn = graph.cross(w, swept);
        let thrown = graph.add_vectors(driven, drawn);
        let thrown = work.vector(self.body(), thrown);
        let thrown = work.components(thrown, Frame::WORLD);
        let total = work.graph.add_vectors(linear, thrown);
        let values = constants(work, &total)?;
        Some(Center {
            acceleration: [values[0], values[1], values[2]],
            offset: (!work.graph.is_zero_vector(&offset)).then_some(offset),
        })
    }

    /// The angular velocity; in the plane, it is about the normal.
    fn angular_velocity(&self, work: &Workspace) -> Components {
        let (zero, rates) = (work.graph.zero(), &self.joint().coordinates);
        let get = |part: usize| rates.get(Variable::AngularVelocity, part).unwrap_or(zero);
        if self.system.is_planar {
            [zero, zero, get(0)]
        } else {
            [0, 1, 2].map(get)
        }
    }

    /// Its rotation in space: that of one body, under the moment that follows from its acceleration
    /// by Euler's equations, or that of a gyrostat.
    fn rotation(&self, work: &mut Workspace, angular: Components) -> Option<Rotation> {
        let (whole, w) = (self.carried(work), self.angular_velocity(work));
        let rows = if self.joint().kind.is_free() {
            whole.about_center
        } else {
            whole.about_origin
        };
        if let Some(rotation) = self.as_one(work, rows, (w, angular)) {
            return Some(rotation);
        }
        let joints = self.system.joints.iter().zip(&self.equations.accelerations);
        let rates =
            joints.flat_map(|(joint, found)| velocities(joint).into_iter().zip(found.clone()));
        let turning = Turning {
            angular_velocity: w,
            angular_acceleration: angular,
            rates: &rates.collect::<Vec<_>>(),
        };
        let axes = self.axes(work);
        Gyrostat::find(work, &turning, &axes).map(Rotation::Gyrostat)
    }

    fn as_one(
        &self,
        work: &mut Workspace,
        rows: [Components; 3],
        (w, angular): (Components, Components),
    ) -> Option<Rotation> {
        let body = self.body();
        let (graph, solid) = (&mut work.graph, Solid { body, rows });
        let moment = Inertia::Spatial(rows).change(graph, w, angular);
        let zero = graph.zero();
        let still = graph.substitute(&moment, |id| w.contains(&id).then_some(zero));
        let still = [still[0], still[1], still[2]];
        let rest = graph.subtract_vectors(moment, still);
        if !all_vanish(work, &rest) {
            return None;
        }
        if all_vanish(work, &still) {
            return Some(Rotation::Free(free(&solid, work)));
        }
        let is_in_world = self.joint().is_in_world();
        is_in_world
            .then(|| symmetric(&solid, work, still))
            .flatten()
    }

    /// The axes about which it may be symmetric: those of all rotors that it carries, at zero
    /// coordinates of the joints between, and its own.
    fn axes(&self, work: &mut Workspace) -> Vec<Components> {
        let (joints, body) = (&self.system.joints, self.body());
        let mut axes = Vec::new();
        for joint in joints {
            if joint.carrier.is_none() || self.system.root(joint.carried) != self.number {
                continue;
            }
            let Some(direction) = joint.directions.first() else {
                continue;
            };
            let frame = self.system.bodies[joint.carried].state.body;
            let axis = work.vector(frame, *direction);
            let axis = work.components(axis, body);
            let axis = at_rest(work, &axis, |_| false);
            if work.graph.are_early(&axis) {
                axes.push([axis[0], axis[1], axis[2]]);
            }
        }
        axes.extend(work.graph.unit_vectors());
        axes
    }
}
