//! Two bodies that do the same, and the ways in which they are timed.

use std::hint::black_box;

use newton_euler::prelude::*;

use crate::paired::paired;
use crate::table::Table;

/// The evaluations in a run. Their states, inputs and results stay in the nearest cache.
const COUNT: u32 = 128;

pub type Acceleration<B> = <<B as RigidBody>::State as State>::Acceleration;

/// A body, and the states and inputs at which it is evaluated.
pub struct Side<B: RigidBody> {
    body: B,
    cases: Vec<(B::State, B::Input)>,
}

impl<B: RigidBody<Scalar = f64>> Side<B> {
    pub fn new(body: B, case: impl Fn(f64) -> (B::State, B::Input)) -> Self {
        let cases = (0..COUNT).map(|i| case(f64::from(i) * 0.37)).collect();
        Self { body, cases }
    }

    fn accelerations(&self) -> Vec<Acceleration<B>> {
        let cases = self.cases.iter();
        cases
            .map(|(state, input)| self.body.acceleration(0.0, state, input))
            .collect()
    }

    /// Independent evaluations, each result stored.
    fn inlined(&self, results: &mut [Acceleration<B>]) {
        for ((state, input), result) in black_box(&self.cases).iter().zip(&mut *results) {
            *result = self.body.acceleration(0.0, state, input);
        }
        black_box(results);
    }

    /// The same, through calls that the compiler cannot look into.
    fn called(&self, results: &mut [Acceleration<B>]) {
        let evaluate = black_box(call::<B> as Evaluate<B>);
        for ((state, input), result) in black_box(&self.cases).iter().zip(&mut *results) {
            evaluate(&self.body, state, input, result);
        }
        black_box(results);
    }

    /// Evaluations each of which needs the result of the one before.
    fn chained(&self, carry: impl Fn(&mut B::State, &mut B::Input, &Acceleration<B>))
    where
        B::Input: Clone,
    {
        let (mut state, mut input) = black_box(&self.cases[1]).clone();
        for _ in 0..COUNT {
            let acceleration = self.body.acceleration(0.0, &state, &input);
            carry(&mut state, &mut input, &acceleration);
        }
        black_box((state, input));
    }
}

type Evaluate<B> = fn(&B, &<B as RigidBody>::State, &<B as RigidBody>::Input, &mut Acceleration<B>);

/// The result stays where it is made, because a copy of it would be timed, too.
#[inline(never)]
fn call<B: RigidBody<Scalar = f64>>(
    body: &B,
    state: &B::State,
    input: &B::Input,
    result: &mut Acceleration<B>,
) {
    *result = body.acceleration(0.0, state, input);
}

/// Two bodies that were checked to do the same.
pub struct Pair<'a, O: RigidBody, H: RigidBody> {
    what: &'a str,
    ours: &'a Side<O>,
    against: &'a Side<H>,
}

impl<'a, O: RigidBody<Scalar = f64>, H: RigidBody<Scalar = f64>> Pair<'a, O, H> {
    /// # Panics
    /// If they do not do the same.
    pub fn checked(
        what: &'a str,
        ours: &'a Side<O>,
        against: &'a Side<H>,
        distance: impl Fn(&Acceleration<O>, &Acceleration<H>) -> f64,
    ) -> Self {
        let (first, second) = (ours.accelerations(), against.accelerations());
        for (one, other) in first.iter().zip(&second) {
            let distance = distance(one, other);
            assert!(distance < 1e-13, "{what}: the two differ by {distance:e}");
        }
        Self {
            what,
            ours,
            against,
        }
    }

    /// Rows for independent evaluations, inlined and called, with the ratios that are to be
    /// reached.
    pub fn independent(&self, table: &mut Table, [inlined, call]: [Option<f64>; 2]) {
        let Self { ours, against, .. } = self;
        let (mut first, mut second) = (ours.accelerations(), against.accelerations());
        let times = paired(
            COUNT,
            || ours.inlined(&mut first),
            || against.inlined(&mut second),
        );
        table.row(format!("{}, inlined", self.what), times, inlined);
        let times = paired(
            COUNT,
            || ours.called(&mut first),
            || against.called(&mut second),
        );
        table.row(format!("{}, call", self.what), times, call);
    }

    /// A row for evaluations each of which needs the result of the one before.
    pub fn chain(
        &self,
        table: &mut Table,
        reach: Option<f64>,
        ours: impl Fn(&mut O::State, &mut O::Input, &Acceleration<O>),
        against: impl Fn(&mut H::State, &mut H::Input, &Acceleration<H>),
    ) where
        O::Input: Clone,
        H::Input: Clone,
    {
        let times = paired(
            COUNT,
            || self.ours.chained(&ours),
            || self.against.chained(&against),
        );
        table.row(format!("{}, chain", self.what), times, reach);
    }
}
