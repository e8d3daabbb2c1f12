//! Inputs of a body during a motion.

use crate::numbers::count::real;

/// Inputs over time.
///
/// [`Integration::input`](crate::integrate::Integration::input) and
/// [`Integration::control`](crate::integrate::Integration::control) create the two kinds.
pub trait Control<S, I> {
    /// The input from a time \[s\] and state on, and the time until which it is held: towards
    /// `end`, or beyond.
    fn input(&mut self, time: f64, state: &S, end: f64) -> (I, f64);

    /// The interval between inputs \[s\], if they are equal.
    fn period(&self) -> Option<f64> {
        None
    }
}

/// One input, held from the start to the end.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held<I>(pub I);

impl<S, I: Default> Control<S, I> for Held<I> {
    fn input(&mut self, time: f64, _state: &S, end: f64) -> (I, f64) {
        (
            core::mem::take(&mut self.0),
            f64::INFINITY.copysign(end - time),
        )
    }
}

/// A function of time and state that is called at equal intervals, and held between them
/// (zero-order hold).
#[derive(Clone, Copy, Debug)]
pub struct Sampled<F> {
    function: F,
    /// The interval between calls \[s\].
    pub(crate) period: f64,
    /// The first instant, and the number of instants so far.
    start: f64,
    count: usize,
}

impl<F> Sampled<F> {
    pub(crate) fn new(period: f64, function: F) -> Self {
        Self {
            function,
            period,
            start: 0.0,
            count: 0,
        }
    }

    /// The function at an instant before an end, and the next instant.
    pub(crate) fn next(&mut self, time: f64, end: f64) -> (&mut F, f64) {
        if self.count == 0 {
            self.start = time;
        }
        self.count += 1;
        let after = real(self.count) * self.period;
        let until = self.start + after * 1.0_f64.copysign(end - self.start);
        (&mut self.function, until)
    }
}

impl<S, I, F: FnMut(f64, &S) -> I> Control<S, I> for Sampled<F> {
    fn input(&mut self, time: f64, state: &S, end: f64) -> (I, f64) {
        let (function, until) = self.next(time, end);
        (function(time, state), until)
    }

    fn period(&self) -> Option<f64> {
        Some(self.period)
    }
}
