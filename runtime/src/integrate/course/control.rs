//! Inputs of a body during a motion.

use crate::numbers::count::real;

/// Only types of this crate are controls: an integration takes inputs as its methods say, and these
/// create the types.
///
/// ```compile_fail,E0277
/// use newton_euler::integrate::Control;
///
/// struct Mine;
///
/// impl Control<f64, ()> for Mine {
///     fn input(&mut self, _: f64, _: &f64, end: f64) -> ((), f64) {
///         ((), end)
///     }
/// }
/// ```
pub trait Closed {}

/// Inputs over time, of two kinds:
/// [`Integration::input`](crate::integrate::Integration::input) and
/// [`Integration::control`](crate::integrate::Integration::control) create them. Other types cannot
/// implement it: a program with inputs of its own gives them as a function, to `control`.
pub trait Control<S, I>: Closed {
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

impl<I> Closed for Held<I> {}

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

    /// The function at an instant before an end, and the next instant. The end is one of them,
    /// despite rounding of their times.
    pub(crate) fn next(&mut self, time: f64, end: f64) -> (&mut F, f64) {
        if self.count == 0 {
            self.start = time;
        }
        self.count += 1;
        let after = real(self.count) * self.period;
        let until = self.start + after * 1.0_f64.copysign(end - self.start);
        let rounding = 1e-12 * after + f64::EPSILON * (self.start.abs() + end.abs());
        let is_end = (until - end).abs() <= rounding;
        (&mut self.function, if is_end { end } else { until })
    }
}

impl<F> Closed for Sampled<F> {}

impl<S, I, F: FnMut(f64, &S) -> I> Control<S, I> for Sampled<F> {
    fn input(&mut self, time: f64, state: &S, end: f64) -> (I, f64) {
        let (function, until) = self.next(time, end);
        (function(time, state), until)
    }

    fn period(&self) -> Option<f64> {
        Some(self.period)
    }
}
