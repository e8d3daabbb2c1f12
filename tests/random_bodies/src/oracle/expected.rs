//! The expected values of all outputs of a body in a state.

use crate::description::body::{Motion, What};
use crate::description::expression::Axes;
use crate::given::Given;
use crate::output::{Answers, Output};

use super::arithmetic::Values as _;
use super::constants::Constants;
use super::following::{follow, following};
use super::inertia::sum;
use super::law::{Motions, given_motion, inertial, kinetic_energy, spin, without};
use super::loads::{Acting, Wrench, acting};
use super::number::Number;
use super::regressed::{Regressed, outputs, regressed};
use super::scene::Scene;
use super::unknowns::{Equations, Open, open_loads, solve};
use super::vector::Vector;

/// What an answer should be.
pub struct Expected {
    pub output: Output,
    /// Of a load, its place in the description.
    pub load: usize,
    pub value: Vector,
}

/// All answers, in the order in which a body is asked; nothing in states that are too near to a switch.
pub fn expected(
    constants: &Constants<'_>,
    given: &Given,
    answers: &Answers,
) -> Option<Vec<Expected>> {
    let scene = Scene::new(constants, given);
    let motions = following(&scene);
    let (loads, applied) = acting_all(&scene);
    let each = || loads.iter().flatten();
    let reactions = open_loads(&scene, true);
    let driving = reactions
        .iter()
        .fold(applied, |all, one| all.and(one.given));
    let mut list = List {
        scene: &scene,
        list: Vec::with_capacity(32),
    };

    list.acceleration(&motions);
    for (index, rate) in constants.body.rates.iter().enumerate() {
        list.tell(Output::Rate, index, Vector::scalar(scene.scalar(rate)));
    }
    list.scalar(Output::KineticEnergy, kinetic_energy(&scene));
    list.scalar(Output::PotentialEnergy, sum(each().map(|load| load.energy)));
    list.momenta();
    list.resultant(
        [Output::AppliedForce, Output::AppliedMoment],
        applied.force,
        applied.about_center,
    );
    list.loads(&loads);

    let missing = without(&inertial(&scene, &motions), &driving);
    let solved = solve(&reactions, &missing, Equations::Both, constants.direction);
    list.unknowns(&reactions, &solved);

    // residuals and drives are those of a motion that is given
    let asked = given_motion(&scene, &given.motion);
    follow(&scene, &asked);
    let (_, applied) = acting_all(&scene);
    let change = inertial(&scene, &asked);
    let answered = reactions
        .iter()
        .fold(applied, |all, open| all.and(told(&scene, open, answers)));
    let residual = without(&answered, &change);
    let from_pole = -scene.arm(&constants.body.pole);
    list.resultant(
        [Output::ResidualForce, Output::ResidualMoment],
        residual.force,
        residual.about_center + from_pole.cross(residual.force),
    );
    list.drives(&without(&change, &applied));
    list.regressor(&asked);
    (!scene.is_near_switch()).then_some(list.list)
}

/// Each load, and all together.
fn acting_all(scene: &Scene<'_>) -> (Vec<Option<Acting>>, Wrench) {
    let loads = scene.constants.body.loads.iter();
    let loads: Vec<Option<Acting>> = loads.map(|load| acting(scene, load)).collect();
    let each = loads.iter().flatten();
    let applied = each.fold(Wrench::ZERO, |all, one| all.and(one.wrench));
    (loads, applied)
}

struct List<'a> {
    scene: &'a Scene<'a>,
    list: Vec<Expected>,
}

impl List<'_> {
    fn tell(&mut self, output: Output, load: usize, value: Vector) {
        // in the plane a moment is a scalar
        let is_planar = self.scene.constants.body.motion.is_planar();
        let value = if is_planar && output.is_moment() {
            Vector::scalar(value.component(2))
        } else {
            value
        };
        self.list.push(Expected {
            output,
            load,
            value,
        });
    }

    fn scalar(&mut self, output: Output, value: Number) {
        self.tell(output, 0, Vector::scalar(value));
    }

    fn acceleration(&mut self, motions: &Motions) {
        let motion = &self.scene.constants.body.motion;
        if matches!(
            motion,
            Motion::Spatial
                | Motion::Planar
                | Motion::Rod(_)
                | Motion::Translation
                | Motion::PlanarTranslation
        ) {
            self.tell(Output::LinearAcceleration, 0, motions.linear);
        }
        if motion.turns() {
            let output = match motion {
                Motion::Rod(_) => Output::AxisAcceleration,
                _ => Output::AngularAcceleration,
            };
            self.tell(output, 0, motions.angular);
        }
    }

    fn momenta(&mut self) {
        let scene = self.scene;
        let spin = spin(scene);
        // where the motion of G is not modeled, its velocity is zero
        let momentum = scene.velocity.scaled(scene.constants.mass);
        let from_pole = -scene.arm(&scene.constants.body.pole);
        self.tell(Output::LinearMomentum, 0, momentum);
        self.tell(Output::AngularMomentum, 0, spin);
        let about_pole = spin + from_pole.cross(momentum);
        self.tell(Output::MomentumAboutPole, 0, about_pole);
    }

    fn resultant(&mut self, outputs: [Output; 2], force: Vector, moment: Vector) {
        if self.scene.constants.body.motion.moves() {
            self.tell(outputs[0], 0, force);
        }
        self.tell(outputs[1], 0, moment);
    }

    fn loads(&mut self, loads: &[Option<Acting>]) {
        for (index, load) in loads.iter().enumerate() {
            let Some(Acting { wrench, point, .. }) = load else {
                continue;
            };
            self.tell(Output::LoadForce, index, wrench.force);
            // what has no point of its own is listed at G
            let couple = point.map_or(wrench.about_center, |_| Vector::ZERO);
            self.tell(Output::LoadPoint, index, point.unwrap_or(self.scene.center));
            self.tell(Output::LoadMoment, index, couple);
        }
    }

    fn unknowns(&mut self, open: &[Open<'_>], solved: &[Vector]) {
        for (open, value) in open.iter().zip(solved) {
            let output = match open.load.what {
                What::OpenForce(..) => Output::UnknownForce,
                _ => Output::UnknownMoment,
            };
            self.tell(output, open.index, *value);
        }
    }

    /// Of a body that does not change.
    fn regressor(&mut self, motions: &Motions) {
        let body = self.scene.constants.body;
        if body.changes {
            return;
        }
        let outputs = outputs(&body.motion);
        let Regressed {
            columns,
            parameters,
        } = regressed(self.scene, motions);
        for (index, [force, moment]) in columns.into_iter().enumerate() {
            for output in outputs {
                let rows = if *output == Output::RegressorForce {
                    force
                } else {
                    moment
                };
                self.tell(*output, index, rows);
            }
        }
        for (index, parameter) in parameters.into_iter().enumerate() {
            self.tell(Output::Parameter, index, Vector::scalar(parameter));
        }
    }

    /// In the axes in which they are written.
    fn drives(&mut self, missing: &Wrench) {
        let (scene, constants) = (self.scene, self.scene.constants);
        let drives = open_loads(scene, false);
        let equations = match constants.body.motion {
            Motion::Rotation | Motion::FixedPoint(_) => Equations::Held,
            Motion::Pivot(_) | Motion::FixedAxis(..) => Equations::Axis,
            _ => Equations::Both,
        };
        let solved = solve(&drives, missing, equations, constants.direction);
        let in_own = |(open, value): (&Open<'_>, Vector)| match open.axes() {
            Axes::Body => scene.in_body(value),
            Axes::World => value,
        };
        let solved: Vec<Vector> = drives.iter().zip(solved).map(in_own).collect();
        self.unknowns(&drives, &solved);
    }
}

/// The wrench of a reaction as the body told it.
fn told(scene: &Scene<'_>, open: &Open<'_>, answers: &Answers) -> Wrench {
    let vector = Vector::given(answers.unknown(open.index));
    match &open.load.what {
        What::OpenForce(_, _, place) => Wrench::of_force(scene, vector, place),
        _ if scene.constants.body.motion.is_planar() => {
            Wrench::couple(Vector::normal(vector.component(0)))
        }
        _ => Wrench::couple(vector),
    }
}
