//! The rotation P of a vector that sweeps: `P' = P (i w + k u)/2`, with P = 1 at time zero.

use nalgebra::Quaternion;

use super::reversal::Reversal;
use super::sweep::{Place, Sweep};
use super::wobble::{lag, tilt};
use crate::numbers::math;
use crate::numbers::twofold::Twofold;

/// P, composed of precession before the spin reverses, the reversal, and precession after it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Passage {
    sweep: Sweep,
    /// The reversal, with its initial P; `None` if the vector sweeps slowly throughout.
    reversal: Option<(Quaternion<f64>, Reversal)>,
    /// For negative u and for positive u; identical if there is no reversal.
    precessions: [Leg; 2],
}

impl Passage {
    pub fn new(sweep: Sweep) -> Self {
        match Reversal::new(&sweep) {
            Some(reversal) => Self::reversing(sweep, &reversal),
            None => Self::precessing(sweep),
        }
    }

    fn precessing(sweep: Sweep) -> Self {
        let middle = sweep.place(Twofold::default());
        let middle = Local::new(&sweep, &middle).lag();
        Self {
            sweep,
            reversal: None,
            precessions: [Leg::from_start(&sweep, middle); 2],
        }
    }

    fn reversing(sweep: Sweep, reversal: &Reversal) -> Self {
        let start = sweep.place(sweep.start);
        let edges = reversal.edges().map(|along| sweep.place(along));
        let at_edges = edges.map(|edge| reversal.at(&edge));
        let after_edge = |side: usize, before: Quaternion<f64>| {
            let (edge, p) = (edges[side], before * at_edges[side]);
            Leg::new(&sweep, 0.0, sweep.time(&edge), edge, p)
        };
        let (before, precessions) = if reversal.holds(&start) {
            let before = reversal.at(&start).conjugate();
            (before, [0, 1].map(|side| after_edge(side, before)))
        } else {
            let (own, side) = (Leg::from_start(&sweep, 0.0), start.side());
            let p = own.at(&sweep, sweep.time(&edges[side]), &edges[side]);
            let before = p * at_edges[side].conjugate();
            let mut precessions = [own; 2];
            precessions[1 - side] = after_edge(1 - side, before);
            (before, precessions)
        };
        Self {
            sweep,
            reversal: Some((before, *reversal)),
            precessions,
        }
    }

    pub fn at(&self, time: f64) -> Quaternion<f64> {
        let time = Twofold::from(time);
        let place = self.sweep.place(self.sweep.start + self.sweep.rate * time);
        match &self.reversal {
            Some((before, reversal)) if reversal.holds(&place) => before * reversal.at(&place),
            _ => self.precessions[place.side()].at(&self.sweep, time, &place),
        }
    }
}

/// A leg of precession about the vector, beginning at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Leg {
    time: Twofold,
    place: Place,
    /// The difference of the phase from `∫ λ dt`, counted from the zero of u.
    lag: f64,
    /// The lag at the zero of u; zero if there is a reversal, because u then keeps its sign.
    middle: f64,
    /// The initial P of the leg.
    before: Quaternion<f64>,
}

impl Leg {
    fn from_start(sweep: &Sweep, middle: f64) -> Self {
        let (start, one) = (sweep.place(sweep.start), Quaternion::identity());
        Self::new(sweep, middle, Twofold::default(), start, one)
    }

    /// From P at a time and point.
    fn new(sweep: &Sweep, middle: f64, time: Twofold, place: Place, p: Quaternion<f64>) -> Self {
        let local = Local::new(sweep, &place);
        Self {
            time,
            place,
            lag: local.lag_from(middle),
            middle,
            before: p * local.rotation().conjugate(),
        }
    }

    fn at(&self, sweep: &Sweep, time: Twofold, place: &Place) -> Quaternion<f64> {
        let local = Local::new(sweep, place);
        let lag = Twofold::from(local.lag_from(self.middle) - self.lag);
        let phase = sweep.phase(&self.place, place, time - self.time) + lag;
        let (sine, cosine) = phase.scaled(-1).sin_cos();
        self.before * Quaternion::new(cosine, 0.0, 0.0, sine) * local.rotation()
    }
}

/// The local properties of a slow sweep.
struct Local {
    /// c and s, of the angle between the third axis and the vector.
    cosine: f64,
    sine: f64,
    /// ε
    ratio: f64,
}

impl Local {
    fn new(sweep: &Sweep, place: &Place) -> Self {
        let length = place.length.value();
        Self {
            cosine: place.along.value() / length,
            sine: sweep.across.value() / length,
            ratio: sweep.rate.value() / length / length,
        }
    }

    fn lag(&self) -> f64 {
        lag(self.cosine.abs(), self.ratio)
    }

    fn lag_from(&self, middle: f64) -> f64 {
        f64::copysign(1.0, self.cosine) * (self.lag() - middle)
    }

    /// `(1 + z i)/|1 + z i| T*`
    fn rotation(&self) -> Quaternion<f64> {
        let [x, y] = tilt(self.cosine, self.sine, self.ratio);
        let size = 1.0 / math::sqrt(1.0 + x * x + y * y);
        let larger = math::sqrt(0.5 + 0.5 * self.cosine.abs());
        let smaller = 0.5 * self.sine / larger;
        let half = if self.cosine < 0.0 {
            [smaller, larger]
        } else {
            [larger, smaller]
        };
        Quaternion::new(size, size * x, size * y, 0.0)
            * Quaternion::new(half[0], 0.0, -half[1], 0.0)
    }
}
