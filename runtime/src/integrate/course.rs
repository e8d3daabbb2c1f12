//! A motion on its way to an end, under inputs that change, and what is seen of it.

use core::fmt;

use crate::body::RigidBody;

use super::control::Control;
use super::error::IntegrationError;
use super::event::{Event, Search};
use super::instants::Instants;
use super::method::{Method, Run};
#[cfg(feature = "progress")]
use super::progress::Bar;

/// A time and the state then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<S> {
    /// \[s\]
    pub time: f64,
    /// The state then.
    pub state: S,
}

/// A motion between its start and its end.
pub(super) struct Course<R, C, B: RigidBody> {
    pub(super) run: R,
    pub(super) control: C,
    /// What acts now, and until when.
    pub(super) input: B::Input,
    pub(super) held_until: f64,
    pub(super) end: f64,
    pub(super) forwards: bool,
    #[cfg(feature = "progress")]
    pub(super) bar: Option<Bar>,
}

/// What a motion gives: a value, or why it ended.
type Outcome<T, B> = Result<T, IntegrationError<<B as RigidBody>::State>>;

impl<B, R, C> Course<R, C, B>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
{
    /// A motion that is to begin.
    pub(super) fn new<'b, M: Method<B, Run<'b> = R>>(
        body: &'b B,
        method: M,
        control: C,
        start: (f64, &B::State),
        end: f64,
    ) -> Self {
        let (time, state) = start;
        Self {
            run: method.start(body, time, state),
            control,
            input: B::Input::default(),
            held_until: time,
            end,
            forwards: end >= time,
            #[cfg(feature = "progress")]
            bar: None,
        }
    }

    /// Whether the motion still has to come to a time.
    fn is_before(&self, time: f64) -> bool {
        let now = self.run.time();
        if self.forwards {
            now < time
        } else {
            now > time
        }
    }

    /// The nearer of two times ahead.
    fn nearer(&self, one: f64, other: f64) -> f64 {
        if self.forwards {
            one.min(other)
        } else {
            one.max(other)
        }
    }

    /// Asks for the input where the last one ends, and says where the next step has to end.
    fn limit(&mut self) -> Outcome<f64, B> {
        let time = self.run.time();
        if !(time.is_finite() && self.end.is_finite()) {
            let state = self.run.state();
            return Err(IntegrationError::NotFinite { time, state });
        }
        if time == self.held_until {
            let state = self.run.state();
            let (input, until) = self.control.input(time, &state, self.end);
            (self.input, self.held_until) = (input, until);
            self.run.renew();
            if !self.is_before(until) {
                let step = until - time;
                return Err(IntegrationError::StepTooSmall { time, state, step });
            }
        }
        Ok(self.nearer(self.held_until, self.end))
    }

    /// Takes a step; false if the end is reached.
    fn step(&mut self) -> Outcome<bool, B> {
        if self.run.time() == self.end {
            return Ok(false);
        }
        let limit = self.limit()?;
        self.run.advance(limit, &self.input)?;
        self.show();
        Ok(true)
    }

    /// Goes on until a time, not beyond the end, lies within the step taken last.
    pub(super) fn seek(&mut self, time: f64) -> Outcome<(), B> {
        while self.is_before(time) || time.is_nan() || !self.run.time().is_finite() {
            let limit = self.limit()?;
            let aim = self.nearer(time, limit);
            self.run.seek(aim, limit, &self.input)?;
            self.show();
        }
        Ok(())
    }

    /// The state at a time within the step taken last.
    fn at(&self, time: f64) -> B::State {
        if time == self.run.time() {
            self.run.state()
        } else {
            self.run.within(time, &self.input)
        }
    }

    #[cfg_attr(
        not(feature = "progress"),
        expect(clippy::unused_self, reason = "nothing to show")
    )]
    fn show(&self) {
        #[cfg(feature = "progress")]
        if let Some(bar) = &self.bar {
            bar.show(self.run.time());
        }
    }
}

/// States at equal intervals: see [`Integration::samples`](super::Integration::samples).
pub struct Samples<R, C, B: RigidBody> {
    course: Course<R, C, B>,
    /// None if the period is none.
    instants: Option<Instants>,
    period: f64,
}

impl<R, C, B> Samples<R, C, B>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
{
    pub(super) fn new(course: Course<R, C, B>, period: f64) -> Self {
        let instants = Instants::new(course.run.time(), course.end, period);
        Self {
            course,
            instants,
            period,
        }
    }
}

impl<R, C, B> Iterator for Samples<R, C, B>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
{
    type Item = Outcome<Sample<B::State>, B>;

    fn next(&mut self) -> Option<Self::Item> {
        let Some(instants) = &mut self.instants else {
            self.instants = Some(Instants::NONE);
            let times = self.course.run.time()..self.course.end;
            let state = self.course.run.state();
            return Some(Err(IntegrationError::uncountable(
                self.period,
                times,
                state,
            )));
        };
        let time = instants.next()?;
        let reached = self.course.seek(time);
        if reached.is_err() {
            *instants = Instants::NONE;
        }
        Some(reached.map(|()| Sample {
            time,
            state: self.course.at(time),
        }))
    }
}

/// The ends of steps: see [`Integration::steps`](super::Integration::steps).
pub struct Steps<R, C, B: RigidBody> {
    pub(super) course: Course<R, C, B>,
    pub(super) is_over: bool,
}

impl<R, C, B> Iterator for Steps<R, C, B>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
{
    type Item = Outcome<Sample<B::State>, B>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.is_over {
            return None;
        }
        match self.course.step() {
            Ok(true) => {
                let (time, state) = (self.course.run.time(), self.course.run.state());
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

/// Zeros of a function: see [`Integration::events`](super::Integration::events).
pub struct Events<R, C, B: RigidBody, F> {
    pub(super) course: Course<R, C, B>,
    pub(super) function: F,
    /// Where in the step taken last.
    pub(super) search: Option<Search>,
    pub(super) is_over: bool,
}

impl<R, C, B, F> Events<R, C, B, F>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
{
    /// The state to which the motion has come: that at the end, when there are no more events.
    pub fn state(&self) -> B::State {
        self.course.run.state()
    }
}

impl<R, C, B, F> Iterator for Events<R, C, B, F>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
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
            let start = self.course.run.time();
            let value = (self.function)(start, &self.course.run.state());
            match self.course.step() {
                Ok(true) => {
                    let length = self.course.run.time() - start;
                    self.search = Some(Search::new(start, length, R::PLACES, value));
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

/// What is underway, by what it has come to.
macro_rules! debug {
    ($($name:ident<$($parameter:ident),*> $course:ident;)*) => {$(
        impl<R: Run<B>, C, B: RigidBody<Scalar = f64>, $($parameter)*> fmt::Debug for $name<R, C, B, $($parameter)*> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.debug_struct(stringify!($name))
                    .field("time", &self.$course.run.time())
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
