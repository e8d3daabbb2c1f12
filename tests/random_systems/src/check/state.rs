//! A random state, with an arbitrary motion and arbitrary loads of joints.

use fastrand::Rng;

use super::compiled::Given;
use crate::draw::Drawn;
use crate::law::closed::Loops;
use crate::law::kind::Rates;
use crate::law::scene::Instant;
use crate::law::space::{Vec3, ZERO};
use crate::wide::Wide;

pub struct State {
    pub time: Wide,
    /// Behind them the user-defined states.
    pub params: Vec<Wide>,
    pub inputs: Vec<Wide>,
    pub rates: Vec<Rates>,
    /// True of what is driven, any of the rest.
    pub accelerations: Vec<Vec<Wide>>,
    pub loads: Vec<[Vec3; 2]>,
}

fn number(rng: &mut Rng, most: f64) -> Wide {
    Wide::from((rng.f64() * 2.0 - 1.0) * most)
}

impl Drawn {
    pub fn loops(&self) -> Loops<'_> {
        Loops {
            links: &self.links,
            rings: &self.rings,
            is_planar: self.is_planar,
        }
    }

    /// Coordinates and rates of what is driven.
    fn prescribe(&self, instant: &Instant<'_>, rates: &mut [Rates]) {
        for (link, (q, v)) in self.links.iter().zip(rates) {
            for (freedom, function) in link.driven.iter().flatten().enumerate() {
                [q[freedom], v[freedom], _] = function(instant);
            }
        }
    }

    /// Any coordinates and rates.
    fn any(&self, rng: &mut Rng) -> Vec<Rates> {
        let links = self.links.iter().map(|link| {
            let count = link.kind.freedoms();
            let mut list = |most: f64| (0..count).map(|_| number(rng, most)).collect::<Vec<_>>();
            let (by, v) = (list(3.0), list(3.0));
            let mut q = vec![Wide::ZERO; count];
            if link.kind.quaternion().is_some() {
                q.push(Wide::ONE);
            }
            (link.kind.moved(&q, &by), v)
        });
        links.collect()
    }

    /// Near those with which the loops are closed, and closed; the time with them.
    fn closed(
        &self,
        (start, from): &(Wide, Vec<Rates>),
        known: Instant<'_>,
        rng: &mut Rng,
    ) -> Option<(Wide, Vec<Rates>)> {
        let counts = self.links.iter().map(|link| link.kind.freedoms());
        let mut any = || -> Vec<Vec<Wide>> {
            let links = counts.clone();
            links
                .map(|count| (0..count).map(|_| number(rng, 1.0)).collect())
                .collect()
        };
        let (by, fast) = (any(), any());
        for reach in [0.5, 0.2, 0.05, 0.0] {
            let time = *start + Wide::from(reach * 0.5);
            let links = self.links.iter().zip(from).zip(by.iter().zip(&fast));
            let rates = links.map(|((link, (q, _)), (by, fast))| {
                let by: Vec<Wide> = by.iter().map(|one| *one * reach).collect();
                let v = fast.iter().map(|one| *one * 2.0).collect();
                (link.kind.moved(q, &by), v)
            });
            let mut rates: Vec<Rates> = rates.collect();
            self.prescribe(&Instant { time, ..known }, &mut rates);
            if let Some(rates) = self.loops().assembled(rates) {
                return Some((time, rates));
            }
        }
        None
    }
}

#[cfg(test)]
impl Drawn {
    /// Where the loops are drawn closed, or this far from there.
    fn beside(&self, far: f64, rng: &mut Rng) -> Option<(Wide, Vec<Rates>)> {
        let (time, from) = self.start.as_ref()?;
        let links = self.links.iter().zip(from).map(|(link, (q, _))| {
            let mut list =
                |most: f64| -> Vec<Wide> { q.iter().map(|_| number(rng, most)).collect() };
            (link.kind.moved(q, &list(far)), list(2.0))
        });
        let rates: Vec<Rates> = links.collect();
        Some((*time, self.loops().assembled(rates)?))
    }
}

impl State {
    /// Where the loops of a linkage are drawn closed, or this far from there.
    #[cfg(test)]
    pub fn beside(drawn: &Drawn, far: f64, rng: &mut Rng) -> Option<Self> {
        let closed = drawn.beside(far, rng)?;
        Some(Self::moving(drawn, closed, rng))
    }

    /// None if its loops do not close.
    pub fn new(drawn: &Drawn, rng: &mut Rng) -> Option<Self> {
        let (inputs, states) = drawn.declared.values();
        let at = |time: Wide| Instant {
            time,
            inputs: &inputs,
            states: &states,
        };
        let (time, rates) = if let Some(start) = &drawn.start {
            drawn.closed(start, at(start.0), rng)?
        } else {
            let time = number(rng, 2.0);
            let mut rates = drawn.any(rng);
            drawn.prescribe(&at(time), &mut rates);
            (time, rates)
        };
        Some(Self::moving(drawn, (time, rates), rng))
    }

    /// Any accelerations and loads.
    fn moving(drawn: &Drawn, (time, rates): (Wide, Vec<Rates>), rng: &mut Rng) -> Self {
        let (inputs, states) = drawn.declared.values();
        let instant = Instant {
            time,
            inputs: &inputs,
            states: &states,
        };
        let (mut accelerations, mut loads) = (Vec::new(), Vec::new());
        for link in &drawn.links {
            let mut a: Vec<Wide> = (0..link.kind.freedoms())
                .map(|_| number(rng, 3.0))
                .collect();
            for (freedom, function) in link.driven.iter().flatten().enumerate() {
                a[freedom] = function(&instant)[2];
            }
            accelerations.push(a);
            let mut load = [0; 2].map(|_| [0; 3].map(|_| number(rng, 5.0)));
            if drawn.is_planar {
                (load[0][2], load[1][0], load[1][1]) = (Wide::ZERO, Wide::ZERO, Wide::ZERO);
            }
            // what is free has none
            if link.kind.is_free() {
                load = [ZERO; 2];
            }
            loads.push(load);
        }
        let params = drawn.declared.params.iter();
        let params = params.map(|(_, value)| (*value).into());
        Self {
            time,
            params: params.chain(states.iter().copied()).collect(),
            inputs,
            rates,
            accelerations,
            loads,
        }
    }

    pub fn instant(&self, drawn: &Drawn) -> Instant<'_> {
        Instant {
            time: self.time,
            inputs: &self.inputs,
            states: &self.params[drawn.declared.params.len()..],
        }
    }

    pub fn given(&self) -> Given<'_> {
        Given {
            time: self.time,
            params: &self.params,
            inputs: &self.inputs,
            rates: &self.rates,
            accelerations: &self.accelerations,
            loads: &self.loads,
        }
    }

    pub fn with(&self, rates: Vec<Rates>) -> Self {
        Self {
            time: self.time,
            params: self.params.clone(),
            inputs: self.inputs.clone(),
            rates,
            accelerations: self.accelerations.clone(),
            loads: self.loads.clone(),
        }
    }

    /// The state next to it.
    pub fn moved(&self, rng: &mut Rng) -> Self {
        let mut near = |list: &[Wide]| -> Vec<Wide> {
            let shift = |part: &Wide, sign: bool| {
                let unit = if sign { 1e-10 } else { -1e-10 };
                *part + *part * unit
            };
            list.iter().map(|part| shift(part, rng.bool())).collect()
        };
        let params = near(&self.params);
        let rates = self.rates.iter().map(|(q, v)| (near(q), near(v))).collect();
        Self {
            params,
            ..self.with(rates)
        }
    }

    /// With another value of a parameter, or of a state behind them.
    pub fn valued(&self, param: usize, by: f64) -> Self {
        let mut state = self.with(self.rates.clone());
        state.params[param] = state.params[param] + Wide::from(by);
        state
    }

    /// A little later, with accelerations by link; of user-defined states, those that drive joints
    /// change.
    pub fn later(&self, drawn: &Drawn, a: &[Vec<Wide>], by: f64) -> Self {
        let time = self.time + Wide::from(by);
        let half = Wide::from(by) * by * 0.5;
        let rates = drawn.links.iter().zip(&self.rates).zip(a);
        let rates = rates.map(|((link, (q, v)), a)| {
            let both = || v.iter().zip(a);
            let step: Vec<Wide> = both().map(|(v, a)| *v * by + *a * half).collect();
            (
                link.kind.moved(q, &step),
                both().map(|(v, a)| *v + *a * by).collect(),
            )
        });
        let mut rates: Vec<Rates> = rates.collect();
        let inputs = self.inputs.iter().enumerate().map(|(number, value)| {
            let next = |number: usize| drawn.declared.rates[number];
            let first = next(number);
            let rate = first.map_or(Wide::ZERO, |place| self.inputs[place]);
            let second = first
                .and_then(next)
                .map_or(Wide::ZERO, |place| self.inputs[place]);
            *value + rate * by + second * half
        });
        let mut later = self.with(Vec::new());
        (later.time, later.inputs) = (time, inputs.collect());
        for led in &drawn.declared.led {
            let state = &mut later.params[drawn.declared.params.len() + led.state];
            *state = *state + (led.rate)(&self.instant(drawn)) * by;
        }
        drawn.prescribe(&later.instant(drawn), &mut rates);
        Self { rates, ..later }
    }

    /// With coordinates moved along these rates, by link.
    pub fn shifted(&self, drawn: &Drawn, along: &[Vec<Wide>], by: f64) -> Self {
        let rates = drawn.links.iter().zip(&self.rates).zip(along);
        let rates = rates.map(|((link, (q, v)), along)| {
            let step: Vec<Wide> = along.iter().map(|one| *one * by).collect();
            (link.kind.moved(q, &step), v.clone())
        });
        self.with(rates.collect())
    }
}

/// The derivative at zero, of fourth order; of what changes within a time or a length of 1 / `pace`.
pub fn slope(pace: f64, of: impl Fn(f64) -> Vec<Wide>) -> Vec<Wide> {
    // a power of two, of which multiples are exact
    let step = (1e-6 / pace).log2().floor().exp2();
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|steps| of(steps * step));
    let all = a.iter().zip(b).zip(c.iter().zip(d));
    let all = all.map(|((a, b), (c, d))| ((*c - b) * 8.0 - (d - *a)) / Wide::from(12.0 * step));
    all.collect()
}
