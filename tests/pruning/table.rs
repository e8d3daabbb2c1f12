//! A row of the table, and what is checked for it.

use newton_euler::operations::{Operations, Stage};
use newton_euler::prelude::*;

use crate::coordinates::{Coordinates, Kind, Moving, Random};
use crate::reference::{Scene, Support, operations};

const STATES: usize = 1000;

/// A rule, in a body in which it applies.
pub struct Row {
    pub rule: &'static str,
    /// The operations of the unpruned reference.
    pub before: u32,
    /// Multiplications, additions and trigonometric functions of the acceleration.
    pub after: [u32; 3],
    /// What the documentation of the body says of it.
    pub skipped: &'static [&'static str],
}

/// How a body and its reference are evaluated.
pub struct Case<B: RigidBody> {
    pub body: B,
    pub operations: &'static [Operations],
    pub skipped: &'static [&'static str],
    pub input: fn(&mut Random) -> B::Input,
    pub scene: fn(&Coordinates, &B::Input) -> Scene,
}

impl Row {
    /// What of it does not hold.
    pub fn check<B: RigidBody<Scalar = f64>>(&self, case: &Case<B>) -> Vec<String>
    where
        B::State: Moving,
    {
        let mut wrong = Vec::new();
        let found = |row: &&Operations| row.function == "acceleration" && row.stage == Stage::State;
        let after = case
            .operations
            .iter()
            .find(found)
            .expect("every body has one");
        if [after.mul, after.add, after.trig] != self.after
            || after.div + after.sqrt + after.other > 0
        {
            wrong.push(format!("{}: after: {after}", self.rule));
        }
        for line in self.skipped {
            if !case.skipped.contains(line) {
                wrong.push(format!(
                    "{}: not said: {line}\n{:#?}",
                    self.rule, case.skipped
                ));
            }
        }
        let mut random = Random(7);
        for _ in 0..STATES {
            let (coordinates, input) = (random.coordinates(), (case.input)(&mut random));
            wrong.extend(self.compare(case, &coordinates, &input));
            if !wrong.is_empty() {
                break;
            }
        }
        wrong
    }

    fn compare<B: RigidBody<Scalar = f64>>(
        &self,
        case: &Case<B>,
        coordinates: &Coordinates,
        input: &B::Input,
    ) -> Vec<String>
    where
        B::State: Moving,
    {
        let acceleration = case
            .body
            .acceleration(0.0, &B::State::at(coordinates), input);
        let computed = B::State::accelerations(&acceleration);
        let scene = (case.scene)(coordinates, input);
        let mut expected = scene.accelerations(coordinates);
        let before = operations(|| {
            scene.accelerations(coordinates);
        });
        let mut wrong = Vec::new();
        if before != self.before {
            wrong.push(format!("{}: before: {before}", self.rule));
        }
        // where G has no coordinates, its acceleration is not asked
        let moves = match scene.support {
            Support::Free | Support::Guided => true,
            Support::Axis(..) => <B::State as Moving>::KIND == Kind::Plane,
            Support::Point(_) => false,
        };
        if !moves {
            expected[0] = expected[0].map(|_| 0.0.into());
        }
        for (computed, expected) in computed.iter().zip(expected) {
            let largest = expected.iter().map(|part| part.largest).fold(0.0, f64::max);
            let unit = largest.next_up() - largest;
            for (computed, expected) in computed.iter().zip(expected) {
                let error = (computed - expected.value).abs();
                if error > 64.0 * unit {
                    let units = error / unit;
                    wrong.push(format!(
                        "{}: {computed}, not {expected:?}: {units} units",
                        self.rule
                    ));
                }
            }
        }
        wrong
    }
}

/// A test of this name: a row, on a body, its inputs and its unpruned reference.
#[macro_export]
macro_rules! row {
    ($name:ident, $body:ident, $input:expr, $scene:expr, $row:expr) => {
        #[test]
        fn $name() {
            let case = $crate::table::Case {
                body: $crate::bodies::$body::default(),
                operations: $crate::bodies::$body::OPERATIONS,
                skipped: $crate::bodies::$body::SKIPPED,
                input: $input,
                scene: $scene,
            };
            let wrong = $row.check(&case);
            assert!(wrong.is_empty(), "{}", wrong.join("\n"));
        }
    };
}
