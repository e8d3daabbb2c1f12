//! Systems of bodies: where they start and end, and how far a state is from that.

mod by_hand;
mod described;
mod starts;

use nalgebra::Vector3;
use newton_euler::prelude::*;

use crate::distance::{Distance, relative};
use crate::measure::{Care, Curve};
use crate::peers::{self, Renormalized};
use crate::problem::Problem;
use crate::reference::{number, system};
use crate::{ours, problems};
use described::{Arm, ArmState, DoublePendulum, DoublePendulumState, Wheels, WheelsState};
use starts::{flying, swinging};

/// All of them, measured.
pub fn all(care: Care) -> Vec<Curve> {
    let file = system("double_pendulum");
    let pendulum = Problem {
        name: "double_pendulum",
        body: DoublePendulum::default(),
        start: swinging(&file),
        seconds: number(&file["trajectory"]["T"]),
        end: swinging(&file["trajectory"]),
    };
    let by_hand = pendulum.of(by_hand::DoublePendulum);
    let methods = [
        ours::smooth(&pendulum),
        peers::general::<4, _, _, _>(&pendulum, &by_hand),
    ];
    let mut curves = problems::measured(care, &pendulum, methods);

    let file = system("satellite3w");
    let wheels = Problem {
        name: "satellite_wheels",
        body: Wheels::default(),
        start: flying(&file),
        seconds: number(&file["trajectory"]["T"]),
        end: flying(&file["trajectory"]),
    };
    let by_hand = wheels.of(by_hand::Wheels::new());
    let methods = [
        ours::smooth(&wheels),
        peers::general::<19, _, _, _>(&wheels, &by_hand),
    ];
    curves.extend(problems::measured(care, &wheels, methods));

    let (file, motion) = (system("ur5"), system("ur5_motion"));
    let arm = Problem {
        name: "six_axis_arm",
        body: Arm::default(),
        start: swinging(&file),
        seconds: number(&motion["T"]),
        end: swinging(&motion),
    };
    let by_hand = arm.of(by_hand::Arm::new());
    let methods = [
        // series of so many products are slower, and take long to build
        ours::stepping(&arm),
        peers::general::<12, _, _, _>(&arm, &by_hand),
    ];
    curves.extend(problems::measured(care, &arm, methods));
    curves
}

/// As of one hinge, rates as one vector.
fn of_hinges<const N: usize>(hinges: [[Hinge; 2]; N]) -> f64 {
    let angles = hinges.map(|[state, right]| (0.5 * (state.angle - right.angle)).abs());
    let rates = [0, 1].map(|k| hinges.map(|pair| pair[k].angular_velocity).into());
    angles
        .into_iter()
        .fold(relative::<N>(&rates[0], &rates[1]), f64::max)
}

macro_rules! of_hinges {
    ($one:expr, $other:expr, $($joint:ident),*) => {
        of_hinges([$([$one.$joint, $other.$joint]),*])
    };
}

impl Distance for DoublePendulumState {
    fn distance(&self, right: &Self) -> f64 {
        of_hinges!(self, right, shoulder, elbow)
    }
}

impl Distance for WheelsState {
    /// Wheels turn hundreds of times: their angles are relative.
    fn distance(&self, right: &Self) -> f64 {
        let angles = [self, right]
            .map(|state| Vector3::new(state.spin_x.angle, state.spin_y.angle, state.spin_z.angle));
        let still = |spin: Hinge| Hinge { angle: 0.0, ..spin };
        let spins = [
            [self.spin_x, right.spin_x],
            [self.spin_y, right.spin_y],
            [self.spin_z, right.spin_z],
        ];
        self.orbit
            .distance(&right.orbit)
            .max(relative(&angles[0], &angles[1]))
            .max(of_hinges(spins.map(|pair| pair.map(still))))
    }
}

impl Distance for ArmState {
    fn distance(&self, right: &Self) -> f64 {
        of_hinges!(self, right, pan, lift, elbow, wrist_1, wrist_2, wrist_3)
    }
}

impl Renormalized for DoublePendulumState {
    fn renormalized(self) -> Self {
        self
    }
}

impl Renormalized for WheelsState {
    #[inline(always)]
    fn renormalized(mut self) -> Self {
        self.orbit = self.orbit.renormalized();
        self
    }
}

impl Renormalized for ArmState {
    fn renormalized(self) -> Self {
        self
    }
}
