//! The closed form of the motion of one joint, proved on its accelerations.

use crate::mechanics::closed_forms::{
    Gyrostat, Rotation, Solid, Turning, constants, free, swing, symmetric,
};
use crate::mechanics::proofs::all_vanish;
use crate::model::{Frame, Inertia, System, TreeJoint, Variable, Workspace};
use crate::symbolic::{Components, Id};

use super::carried::Carried;
use crate::mechanics::system::equations::SystemEquations;
use crate::mechanics::system::rates::velocities;

/// How a joint moves.
pub enum Course {
    /// Every coordinate has a constant acceleration.
    Uniform(Vec<Id>),
    /// It rotates; the center of mass of a free joint moves on a parabola.
    Turning(Rotation, Option<Center>),
}

/// The motion of the center of mass of everything that a free joint carries.
pub struct Center {
    /// Constant, world axes.
    pub acceleration: Components,
    /// From G of the body, body axes, if it is elsewhere.
    pub offset: Option<Components>,
}

/// A joint of a system, whose accelerations are known.
pub struct Moving<'a> {
    pub system: &'a System,
    pub equations: &'a SystemEquations,
    pub number: usize,
}

impl Moving<'_> {
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

    /// The parabola of the center of mass, if it moves on one: `a + w' x c + w x (w x c)` is
    /// constant.
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

    /// In the plane about its normal.
    fn angular_velocity(&self, work: &Workspace) -> Components {
        let (zero, rates) = (work.graph.zero(), &self.joint().coordinates);
        let get = |part: usize| rates.get(Variable::AngularVelocity, part).unwrap_or(zero);
        if self.system.is_planar {
            [zero, zero, get(0)]
        } else {
            [0, 1, 2].map(get)
        }
    }

    /// Its rotation in space: as one body under the moment that its acceleration leaves in Euler's
    /// equations, or as a gyrostat.
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

    /// The axes about which it may be symmetric: those of its rotors, and its own.
    fn axes(&self, work: &mut Workspace) -> Vec<Components> {
        let joints = self.system.joints.iter();
        let on_it = joints.filter(|joint| joint.carrier == Some(self.joint().carried));
        let rotors = on_it.filter(|joint| joint.turned.is_empty());
        let directions = rotors.filter_map(|joint| joint.directions.first().copied());
        directions.chain(work.graph.unit_vectors()).collect()
    }
}
