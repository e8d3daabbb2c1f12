//! Additional conditions on a steady motion.

/// Conditions: functions of state and input that must be zero.
pub trait Conditions<S, I> {
    /// The name and the value of each.
    fn each(&self, state: &S, input: &I, found: &mut dyn FnMut(&'static str, f64));
}

impl<S, I> Conditions<S, I> for () {
    fn each(&self, _state: &S, _input: &I, _found: &mut dyn FnMut(&'static str, f64)) {}
}

/// A condition added to others.
#[derive(Clone, Copy, Debug)]
pub struct Condition<C, F> {
    pub(super) others: C,
    pub(super) name: &'static str,
    pub(super) value: F,
}

impl<S, I, C: Conditions<S, I>, F: Fn(&S, &I) -> f64> Conditions<S, I> for Condition<C, F> {
    fn each(&self, state: &S, input: &I, found: &mut dyn FnMut(&'static str, f64)) {
        self.others.each(state, input, found);
        found(self.name, (self.value)(state, input));
    }
}
