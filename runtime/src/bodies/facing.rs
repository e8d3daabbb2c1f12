//! The way back from assemblies other than the one that is meant, such as a reversed axis.

use core::f64::consts::FRAC_PI_2;

use crate::state::Coordinates;

/// Newton's method takes over where all cosines are at least this, 26 degrees: if a weld is turned by
/// 60 degrees about a diagonal of its axes, the values of its angles no longer decrease on the way
/// back.
const NEAR: f64 = 0.9;

/// The most turns.
const TURNS: usize = 100;

/// The least gain of a turn that is taken.
const GAIN: f64 = 1e-3;

/// The rounding error of the four values of a cosine.
const SINE_WAVE: f64 = 1e-9;

/// A turn of one coordinate.
struct Turn {
    /// The place of its rate in the list.
    rate: usize,
    angle: f64,
    gain: f64,
}

/// Turns one coordinate at a time, that of the largest gain, to the largest sum of the cosines that
/// are one in the assembly that is meant (a greedy form of cyclic coordinate descent: L. Wang,
/// C. Chen, IEEE Transactions on Robotics and Automation 7, 1991, 489). Returns whether the state
/// is new.
pub(super) fn face<S, const N: usize>(state: &mut S, cosines: impl Fn(&S) -> [f64; N]) -> bool
where
    S: Coordinates<Scalar = f64, Acceleration: Default>,
{
    for turns in 0..TURNS {
        let now = cosines(state);
        if now.iter().all(|cosine| *cosine >= NEAR) {
            return turns > 0;
        }
        let all = S::GROUPS.iter().sum();
        let best = (positions::<S>()..all).map(|rate| best(state, rate, &now, &cosines));
        let best = best.reduce(|a, b| if b.gain > a.gain { b } else { a });
        let Some(best) = best.filter(|best| best.gain > GAIN) else {
            return turns > 0;
        };
        *state = state.moved(&(along(state, best.rate) * best.angle));
    }
    true
}

/// The best angle of one coordinate. Most cosines change with an angle as
/// `mean + b cos angle + c sin angle`, which four values show; the others do not count.
fn best<S, const N: usize>(
    state: &S,
    rate: usize,
    now: &[f64; N],
    cosines: impl Fn(&S) -> [f64; N],
) -> Turn
where
    S: Coordinates<Scalar = f64, Acceleration: Default>,
{
    let direction = along(state, rate);
    let [ahead, opposite, behind] = [1.0, 2.0, 3.0].map(|quarters| {
        let angle = quarters * FRAC_PI_2;
        cosines(&state.moved(&(direction * angle)))
    });
    let (mut b, mut c) = (0.0, 0.0);
    let rows = now.iter().zip(ahead).zip(opposite).zip(behind);
    for (((now, ahead), opposite), behind) in rows {
        if (now + opposite - ahead - behind).abs() < SINE_WAVE {
            b += 0.5 * (now - opposite);
            c += 0.5 * (ahead - behind);
        }
    }
    Turn {
        rate,
        angle: libm::atan2(c, b),
        gain: libm::hypot(b, c) - b,
    }
}

/// The displacement along one coordinate, given by the place of its rate in the list.
fn along<S>(state: &S, rate: usize) -> S::Rate
where
    S: Coordinates<Scalar = f64, Acceleration: Default>,
{
    let mut list = state.coordinates();
    let rates = list.as_mut().iter_mut().enumerate().skip(positions::<S>());
    for (place, number) in rates {
        *number = if place == rate { 1.0 } else { 0.0 };
    }
    S::from_coordinates(&list).rate(&S::Acceleration::default())
}

/// The number of coordinates before the rates.
fn positions<S: Coordinates>() -> usize {
    S::GROUPS.iter().take(S::GROUPS.len() / 2).sum()
}
