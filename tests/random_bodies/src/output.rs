//! The outputs of a body, as a list of vectors.

use std::fmt;

use nalgebra::{SMatrix, Vector2, Vector3};
use newton_euler::prelude::*;

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Output {
    LinearAcceleration,
    AngularAcceleration,
    AxisAcceleration,
    KineticEnergy,
    PotentialEnergy,
    LinearMomentum,
    AngularMomentum,
    MomentumAboutPole,
    AppliedForce,
    AppliedMoment,
    LoadForce,
    LoadPoint,
    LoadMoment,
    UnknownForce,
    UnknownMoment,
    ResidualForce,
    ResidualMoment,
    Rate,
    RegressorForce,
    RegressorMoment,
    Parameter,
}

impl Output {
    pub const ALL: [Self; 21] = [
        Self::LinearAcceleration,
        Self::AngularAcceleration,
        Self::AxisAcceleration,
        Self::KineticEnergy,
        Self::PotentialEnergy,
        Self::LinearMomentum,
        Self::AngularMomentum,
        Self::MomentumAboutPole,
        Self::AppliedForce,
        Self::AppliedMoment,
        Self::LoadForce,
        Self::LoadPoint,
        Self::LoadMoment,
        Self::UnknownForce,
        Self::UnknownMoment,
        Self::ResidualForce,
        Self::ResidualMoment,
        Self::Rate,
        Self::RegressorForce,
        Self::RegressorMoment,
        Self::Parameter,
    ];

    /// Whether it is a moment, or has the direction of one.
    pub fn is_moment(self) -> bool {
        matches!(
            self,
            Self::AngularMomentum
                | Self::MomentumAboutPole
                | Self::AppliedMoment
                | Self::LoadMoment
                | Self::UnknownMoment
                | Self::ResidualMoment
        )
    }
}

impl fmt::Display for Output {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::LinearAcceleration => "acceleration of G",
            Self::AngularAcceleration => "angular acceleration",
            Self::AxisAcceleration => "acceleration of the axis",
            Self::KineticEnergy => "kinetic energy",
            Self::PotentialEnergy => "potential energy",
            Self::LinearMomentum => "linear momentum",
            Self::AngularMomentum => "angular momentum",
            Self::MomentumAboutPole => "angular momentum about the pole",
            Self::AppliedForce => "applied force",
            Self::AppliedMoment => "applied moment",
            Self::LoadForce => "force of a load",
            Self::LoadPoint => "point of a load",
            Self::LoadMoment => "moment of a load",
            Self::UnknownForce => "unknown force",
            Self::UnknownMoment => "unknown moment",
            Self::ResidualForce => "residual force",
            Self::ResidualMoment => "residual moment",
            Self::Rate => "rate of a state",
            Self::RegressorForce => "force by a parameter",
            Self::RegressorMoment => "moment by a parameter",
            Self::Parameter => "inertial parameter",
        })
    }
}

/// The answers of one body in one state, in the order in which it was asked.
#[derive(Debug, Default)]
pub struct Answers {
    pub list: Vec<(Output, usize, [f64; 3])>,
    /// The rows of the accelerations and of the rates in a linearization, by columns of the state,
    /// and behind them by columns of the parameters.
    pub derivatives: Vec<Vec<f64>>,
    /// Whether `new` refused the parameters.
    pub refused: bool,
}

impl Answers {
    pub fn clear(&mut self) {
        self.list.clear();
        self.derivatives.clear();
        self.refused = false;
    }

    pub fn refuse(&mut self) {
        self.refused = true;
    }

    pub fn unknown(&self, load: usize) -> [f64; 3] {
        let is_unknown =
            |output: Output| matches!(output, Output::UnknownForce | Output::UnknownMoment);
        let found = self
            .list
            .iter()
            .find(|(output, of, _)| *of == load && is_unknown(*output));
        found.map_or([f64::NAN; 3], |(.., value)| *value)
    }

    fn tell(&mut self, output: Output, load: usize, value: &impl Numbers) {
        self.list.push((output, load, value.numbers()));
    }

    pub fn acceleration<S: Accelerated>(&mut self, _: &S, acceleration: &S::Acceleration) {
        S::tell(acceleration, self);
    }

    pub fn linearization<const N: usize>(&mut self, a: &SMatrix<f64, N, N>, own: usize) {
        let first = (N - own) / 2;
        let rows = (first..N).map(|row| a.row(row).iter().copied().collect());
        self.derivatives = rows.collect();
    }

    pub fn sensitivity<const N: usize, const P: usize>(&mut self, by_params: &SMatrix<f64, N, P>) {
        for (row, more) in self.derivatives.iter_mut().zip(by_params.row_iter()) {
            row.extend(more.iter());
        }
    }

    /// Columns of forces, of moments, or of both, of which forces come first.
    pub fn regressor<const R: usize, const C: usize>(
        &mut self,
        columns: &SMatrix<f64, R, C>,
        parameters: &SMatrix<f64, C, 1>,
        [forces, moments]: [usize; 2],
    ) {
        for (index, column) in columns.column_iter().enumerate() {
            let rows: Vec<f64> = column.iter().copied().collect();
            assert_eq!(rows.len(), forces + moments);
            let (first, second) = rows.split_at(forces);
            for (output, rows) in [
                (Output::RegressorForce, first),
                (Output::RegressorMoment, second),
            ] {
                if !rows.is_empty() {
                    let part = |i: usize| rows.get(i).copied().unwrap_or_default();
                    self.list.push((output, index, [0, 1, 2].map(part)));
                }
            }
        }
        for (index, parameter) in parameters.iter().enumerate() {
            self.tell(Output::Parameter, index, parameter);
        }
    }

    pub fn rate(&mut self, index: usize, rate: f64) {
        self.tell(Output::Rate, index, &rate);
    }

    pub fn energy<B: Energy<Scalar = f64>>(
        &mut self,
        body: &B,
        time: f64,
        state: &B::State,
        input: &B::Input,
    ) {
        self.tell(Output::KineticEnergy, 0, &body.kinetic_energy(state));
        let potential = body.potential_energy(time, state, input);
        self.tell(Output::PotentialEnergy, 0, &potential);
    }

    pub fn momentum<B>(&mut self, body: &B, time: f64, state: &B::State)
    where
        B: Momentum<Scalar = f64, Linear: Numbers, Angular: Numbers>,
    {
        self.tell(Output::LinearMomentum, 0, &body.linear_momentum(state));
        self.tell(Output::AngularMomentum, 0, &body.angular_momentum(state));
        let about_pole = body.angular_momentum_about_pole(time, state);
        self.tell(Output::MomentumAboutPole, 0, &about_pole);
    }

    pub fn loads<const N: usize>(&mut self, applied: &impl Resultant, loads: &[impl Listed; N]) {
        applied.tell(self, Output::AppliedForce, Output::AppliedMoment);
        for load in loads {
            load.tell(self);
        }
    }

    pub fn residual(&mut self, residual: &impl Resultant) {
        residual.tell(self, Output::ResidualForce, Output::ResidualMoment);
    }

    pub fn unknown_force(&mut self, load: usize, force: &impl Numbers) {
        self.tell(Output::UnknownForce, load, force);
    }

    pub fn unknown_moment(&mut self, load: usize, moment: &impl Numbers) {
        self.tell(Output::UnknownMoment, load, moment);
    }
}

/// Scalars are in the first place; where there is nothing, there are zeros.
pub trait Numbers {
    fn numbers(&self) -> [f64; 3];
}

impl Numbers for () {
    fn numbers(&self) -> [f64; 3] {
        [0.0; 3]
    }
}

impl<N: Numbers> Numbers for &N {
    fn numbers(&self) -> [f64; 3] {
        (*self).numbers()
    }
}

impl Numbers for f64 {
    fn numbers(&self) -> [f64; 3] {
        [*self, 0.0, 0.0]
    }
}

impl Numbers for Vector2<f64> {
    fn numbers(&self) -> [f64; 3] {
        [self.x, self.y, 0.0]
    }
}

impl Numbers for Vector3<f64> {
    fn numbers(&self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }
}

/// A state by whose kind accelerations are known.
pub trait Accelerated: State {
    fn tell(acceleration: &Self::Acceleration, answers: &mut Answers);
}

macro_rules! accelerated {
    ($($state:ty: $($output:ident $(= $field:ident)?),+;)+) => {$(
        impl Accelerated for $state {
            fn tell(acceleration: &Self::Acceleration, answers: &mut Answers) {
                $(answers.tell(Output::$output, 0, &acceleration$(.$field)?);)+
            }
        }
    )+};
}

accelerated! {
    Spatial: LinearAcceleration = linear, AngularAcceleration = angular;
    Planar: LinearAcceleration = linear, AngularAcceleration = angular;
    Rod: LinearAcceleration = linear, AxisAcceleration = axis;
    Translation: LinearAcceleration;
    PlanarTranslation: LinearAcceleration;
    Rotation: AngularAcceleration;
    Hinge: AngularAcceleration;
}

/// Force and moment, or the moment alone.
pub trait Resultant {
    fn tell(&self, answers: &mut Answers, force: Output, moment: Output);
}

impl Resultant for Wrench {
    fn tell(&self, answers: &mut Answers, force: Output, moment: Output) {
        answers.tell(force, 0, &self.force);
        answers.tell(moment, 0, &self.moment);
    }
}

impl Resultant for PlanarWrench {
    fn tell(&self, answers: &mut Answers, force: Output, moment: Output) {
        answers.tell(force, 0, &self.force);
        answers.tell(moment, 0, &self.moment);
    }
}

impl Resultant for Vector3<f64> {
    fn tell(&self, answers: &mut Answers, _force: Output, moment: Output) {
        answers.tell(moment, 0, self);
    }
}

pub trait Listed {
    fn tell(&self, answers: &mut Answers);
}

macro_rules! listed {
    ($($kind:ty),+) => {$(
        impl Listed for $kind {
            fn tell(&self, answers: &mut Answers) {
                let digits = self.name.trim_start_matches("load_");
                let load = digits.parse().expect("loads are numbered");
                answers.tell(Output::LoadForce, load, &self.force);
                answers.tell(Output::LoadPoint, load, &self.point);
                answers.tell(Output::LoadMoment, load, &self.moment);
            }
        }
    )+};
}

listed!(Load, PlanarLoad);
