//! A motion on its way to an end, under inputs that change, and what is seen of it.

use core::borrow::Borrow;
use core::fmt;
use core::iter::Empty;

use crate::body::RigidBody;

use super::control::Control;
use super::error::IntegrationError;
use super::event::{Event, Search};
use super::instants::Instants;
use super::method::{Method, Run};
#[cfg(feature = "progress")]
use super::progress::Bar;
use super::switches::Stretch;

/// A time and the state then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<S> {
    /// \[s\]
    pub time: f64,
    /// The state then.
    pub state: S,
}

/// How long steps are at most, and where they end beside.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace<L> {
    /// \[s\]
    pub(crate) max_step: f64,
    /// Times \[s\], in any order.
    pub(crate) breaks: L,
}

impl<L> Pace<L> {
    /// Where a step from a time on has to end, if there are other reasons to end at a limit: none if there is no such step.
    pub(crate) fn limit(&self, time: f64, limit: f64) -> Option<f64> {
        let longest = self.max_step > 0.0;
        let step = self.max_step.min((limit - time).abs());
        let next = if step < (limit - time).abs() {
            time + step.copysign(limit - time)
        } else {
            limit
        };
        (longest && next != time).then_some(next)
    }
}

/// A motion between its start and its end.
pub(crate) struct Course<R, C, B: RigidBody, L> {
    pub(crate) run: R,
    pub(crate) control: C,
    /// What acts now, and until when.
    pub(crate) input: B::Input,
    pub(crate) held_until: f64,
    /// When it was given, if that was before it is asked for.
    pub(crate) given: Option<f64>,
    /// In which the motion is.
    pub(crate) stretch: Stretch,
    pub(crate) pace: Pace<L>,
    pub(crate) end: f64,
    pub(crate) forwards: bool,
    #[cfg(feature = "progress")]
    pub(crate) bar: Option<Bar>,
}

/// What a motion gives: a value, or why it ended.
type Outcome<T, B> = Result<T, IntegrationError<<B as RigidBody>::State>>;

impl<B, R, C, L> Course<R, C, B, L>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
    L: Iterator<Item: Borrow<f64>> + Clone,
{
    /// A motion that is to begin.
    pub(crate) fn new<'b, M: Method<B, Run<'b> = R>>(
        body: &'b B,
        method: M,
        control: C,
        pace: Pace<L>,
        start: (f64, &B::State),
        end: f64,
    ) -> Self
    where
        B: 'b,
    {
        let (time, state) = start;
        Self {
            run: method.start(body, time, state),
            control,
            input: B::Input::default(),
            given: None,
            held_until: time,
            stretch: Stretch {
                next: time,
                ..Stretch::ALL
            },
            pace,
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

    /// Asks for the input where the last one ends, looks how far the equations do not change, and says where the next step has to end.
    fn limit(&mut self) -> Outcome<f64, B> {
        let time = self.run.time();
        if !(time.is_finite() && self.end.is_finite()) {
            let state = self.run.state();
            return Err(IntegrationError::not_finite(time, state));
        }
        let is_given = time == self.held_until;
        if is_given {
            let state = self.run.state();
            let (input, until) = self.control.input(time, &state, self.end);
            (self.input, self.held_until) = (input, until);
            self.run.renew();
            if !self.is_before(until) {
                let step = until - time;
                return Err(IntegrationError::StepTooSmall { time, state, step });
            }
        }
        if is_given || !self.is_before(self.stretch.next) {
            let given = if is_given {
                self.given.unwrap_or(time)
            } else {
                self.stretch.given
            };
            let (from, breaks) = ((time, self.forwards, 0), self.pace.breaks.clone());
            let stretch = Stretch::of(self.run.body(), &self.input, from, breaks);
            self.stretch = Stretch { given, ..stretch };
            self.run.enter(self.stretch);
        }
        let limit = self.nearer(self.nearer(self.held_until, self.end), self.stretch.next);
        self.pace.limit(time, limit).ok_or_else(|| {
            let (state, step) = (self.run.state(), self.pace.max_step);
            IntegrationError::StepTooSmall { time, state, step }
        })
    }

    /// Takes a step; false if the end is reached.
    fn step(&mut self) -> Outcome<bool, B> {
        if self.run.time() == self.end {
            return Ok(false);
        }
        let limit = self.limit()?;
        let reached = self.run.advance(limit, &self.input);
        self.named(reached)?;
        self.show();
        Ok(true)
    }

    /// Goes on until a time, not beyond the end, lies within the step taken last.
    pub(crate) fn seek(&mut self, time: f64) -> Outcome<(), B> {
        while self.is_before(time) || time.is_nan() || !self.run.time().is_finite() {
            let limit = self.limit()?;
            let reached = if self.pace.max_step < f64::INFINITY {
                self.run.advance(limit, &self.input)
            } else {
                let aim = self.nearer(time, limit);
                self.run.seek(aim, limit, &self.input)
            };
            self.named(reached)?;
            self.show();
        }
        Ok(())
    }

    /// An error with the load that has no value, if there is one.
    fn named(&self, reached: Outcome<(), B>) -> Outcome<(), B> {
        reached.map_err(|error| {
            let (body, since) = (self.run.body(), error.time() - self.stretch.given);
            let moved = body.input_after(&self.input, since);
            error.named(body, moved.as_ref().unwrap_or(&self.input), self.forwards)
        })
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
pub struct Samples<R, C, B: RigidBody, L = Empty<f64>> {
    course: Course<R, C, B, L>,
    /// None if the period is none.
    instants: Option<Instants>,
    period: f64,
}

impl<R, C, B, L> Samples<R, C, B, L>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
    L: Iterator<Item: Borrow<f64>> + Clone,
{
    pub(super) fn new(course: Course<R, C, B, L>, period: f64) -> Self {
        let instants = Instants::new(course.run.time(), course.end, period);
        Self {
            course,
            instants,
            period,
        }
    }
}

impl<R, C, B, L> Iterator for Samples<R, C, B, L>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
    L: Iterator<Item: Borrow<f64>> + Clone,
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
pub struct Steps<R, C, B: RigidBody, L = Empty<f64>> {
    pub(super) course: Course<R, C, B, L>,
    pub(super) is_over: bool,
}

impl<R, C, B, L> Iterator for Steps<R, C, B, L>
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
pub struct Events<R, C, B: RigidBody, F, L = Empty<f64>> {
    pub(super) course: Course<R, C, B, L>,
    pub(super) function: F,
    /// Where in the step taken last.
    pub(super) search: Option<Search>,
    pub(super) is_over: bool,
}

impl<R, C, B, F, L> Events<R, C, B, F, L>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
    L: Iterator<Item: Borrow<f64>> + Clone,
{
    /// The state to which the motion has come: that at the end, when there are no more events.
    pub fn state(&self) -> B::State {
        self.course.run.state()
    }
}

impl<R, C, B, F, L> Iterator for Events<R, C, B, F, L>
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
        impl<R: Run<B>, C, B: RigidBody<Scalar = f64>, $($parameter,)* L> fmt::Debug for $name<R, C, B, $($parameter,)* L> {
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
