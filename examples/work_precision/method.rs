//! Ways to the end of a problem.

/// A way to the end, with its name.
pub struct Method<'p, S> {
    pub name: String,
    pub way: Way<'p, S>,
}

/// What is asked of a method, and where it then arrives.
pub enum Way<'p, S> {
    /// Nothing: there is one answer.
    Closed(Box<dyn Fn() -> S + 'p>),
    /// A number of steps.
    Fixed(Box<dyn Fn(u32) -> S + 'p>),
    /// A tolerance; no end, where the method cannot keep it.
    Adaptive(Box<dyn Fn(f64) -> Option<S> + 'p>),
}

impl<'p, S> Method<'p, S> {
    pub fn closed(name: impl Into<String>, end: impl Fn() -> S + 'p) -> Self {
        Self {
            name: name.into(),
            way: Way::Closed(Box::new(end)),
        }
    }

    pub fn fixed(name: impl Into<String>, end: impl Fn(u32) -> S + 'p) -> Self {
        Self {
            name: name.into(),
            way: Way::Fixed(Box::new(end)),
        }
    }

    pub fn adaptive(name: impl Into<String>, end: impl Fn(f64) -> Option<S> + 'p) -> Self {
        Self {
            name: name.into(),
            way: Way::Adaptive(Box::new(end)),
        }
    }

    /// What is asked of it one time after the other, finer and finer: steps or tolerance.
    pub fn efforts(&self) -> Vec<f64> {
        match self.way {
            Way::Closed(_) => vec![0.0],
            Way::Fixed(_) => (2..22)
                .flat_map(|k| [1_u32 << k, 3 << (k - 1)])
                .map(f64::from)
                .collect(),
            Way::Adaptive(_) => (2..31).map(|k| 10_f64.powf(-0.5 * f64::from(k))).collect(),
        }
    }

    /// Where it arrives with that effort.
    pub fn end(&self, effort: f64) -> Option<S> {
        match &self.way {
            Way::Closed(end) => Some(end()),
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "counts"
            )]
            Way::Fixed(end) => Some(end(effort as u32)),
            Way::Adaptive(end) => end(effort),
        }
    }
}
