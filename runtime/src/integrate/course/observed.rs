//! Observations of a motion: samples, the ends of steps, events.

use core::borrow::Borrow;
use core::fmt;
use core::iter::Empty;

use super::Course;
use super::control::Control;
use super::instants::Instants;
use super::underway::Outcome;
use crate::bodies::body::RigidBody;
use crate::bodies::columns::{Columns, Named, Names, Sink, Source};
use crate::integrate::steps::event::{Event, Search};
use crate::integrate::steps::method::Run;
use crate::integrate::steps::setting::{Setting, check};

/// A time and the state at it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<S> {
    /// \[s\]
    pub time: f64,
    /// The state at this time.
    pub state: S,
}

impl<S: Columns<f64>> Columns<f64> for Sample<S> {
    const COUNT: usize = 1 + S::COUNT;

    fn read(source: &mut impl Source<f64>) -> Self {
        let time = source.take();
        let state = S::read(source);
        Self { time, state }
    }

    fn write(&self, sink: &mut impl Sink<f64>) {
        sink.put(self.time);
        self.state.write(sink);
    }
}

/// The time, and the columns of the state.
impl<S: Named> Named for Sample<S> {
    const NAMES: Names = Names::Parts(&[("time", Names::Number("s")), ("", S::NAMES)]);
}

/// States at equal intervals: see [`Integration::samples`](crate::integrate::Integration::samples).
pub struct Samples<'b, R, C, B: RigidBody, L = Empty<f64>> {
    course: Course<'b, R, C, B, L>,
    instants: Instants,
}

impl<'b, R, C, B, L> Samples<'b, R, C, B, L>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
    L: Iterator<Item: Borrow<f64>> + Clone,
{
    pub(super) fn new(mut course: Course<'b, R, C, B, L>, period: f64) -> Self {
        let times = course.time()..course.end;
        let checked = check(&times, [(Setting::Period, period)]);
        course.refused = course.refused.or(checked.err());
        let instants = Instants::new(times, period);
        Self { course, instants }
    }
}

impl<R, C, B, L> Iterator for Samples<'_, R, C, B, L>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
    L: Iterator<Item: Borrow<f64>> + Clone,
{
    type Item = Outcome<Sample<B::State>, B>;

    fn next(&mut self) -> Option<Self::Item> {
        let time = self.instants.next()?;
        let reached = self.course.seek(time);
        if reached.is_err() {
            self.instants = Instants::NONE;
        }
        Some(reached.map(|()| Sample {
            time,
            state: self.course.at(time),
        }))
    }
}

/// The ends of steps: see [`Integration::steps`](crate::integrate::Integration::steps).
pub struct Steps<'b, R, C, B: RigidBody, L = Empty<f64>> {
    pub(super) course: Course<'b, R, C, B, L>,
    pub(super) is_over: bool,
}

impl<R, C, B, L> Iterator for Steps<'_, R, C, B, L>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
    L: Iterator<Item: Borrow<f64>> + Clone,
{
    type Item = Outcome<Sample<B::State>, B>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.is_over {
            return None;
        }
        match self.course.step() {
            Ok(true) => {
                let (time, state) = (self.course.time(), self.course.state());
                Some(Ok(Sample { time, state }))
            }
            Ok(false) => None,
            Err(error) => {
                self.is_over = true;
                Some(Err(error))
            }
        }
    }
}

/// Zeros of a function: see [`Integration::events`](crate::integrate::Integration::events).
pub struct Events<'b, R, C, B: RigidBody, F, L = Empty<f64>> {
    pub(super) course: Course<'b, R, C, B, L>,
    pub(super) function: F,
    /// The search within the last step.
    pub(super) search: Option<Search>,
    pub(super) is_over: bool,
}

impl<R, C, B, F, L> Events<'_, R, C, B, F, L>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
    L: Iterator<Item: Borrow<f64>> + Clone,
{
    /// The current state of the motion: the end state, when there are no more events.
    pub fn state(&self) -> B::State {
        self.course.state()
    }
}

impl<R, C, B, F, L> Iterator for Events<'_, R, C, B, F, L>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
    L: Iterator<Item: Borrow<f64>> + Clone,
    F: Fn(f64, &B::State) -> f64,
{
    type Item = Outcome<Event<B::State>, B>;

    fn next(&mut self) -> Option<Self::Item> {
        while !self.is_over {
            if let Some(search) = &mut self.search {
                let course = &self.course;
                let found = search.next(|time| course.at(time), &self.function);
                if found.is_some() {
                    self.is_over = matches!(found, Some(Err(_)));
                    return found;
                }
            }
            let start = self.course.time();
            let value = (self.function)(start, &self.course.state());
            match self.course.step() {
                Ok(true) => {
                    let times = start..self.course.time();
                    self.search = Some(Search::new(times, R::PLACES, value));
                }
                Ok(false) => self.is_over = true,
                Err(error) => {
                    self.is_over = true;
                    return Some(Err(error));
                }
            }
        }
        None
    }
}

/// Implements `Debug` by the current state.
macro_rules! debug {
    ($($name:ident<$($parameter:ident),*> $course:ident;)*) => {$(
        impl<R: Run<B>, C, B: RigidBody<Scalar = f64>, $($parameter,)* L> fmt::Debug for $name<'_, R, C, B, $($parameter,)* L> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.debug_struct(stringify!($name))
                    .field("time", &self.$course.underway.run.time())
                    .field("end", &self.$course.end)
                    .finish_non_exhaustive()
            }
        }
    )*};
}

debug! {
    Samples<> course;
    Steps<> course;
    Events<F> course;
}
