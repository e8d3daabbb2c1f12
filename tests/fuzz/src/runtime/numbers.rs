//! Doubles of every kind.

use fastrand::Rng;

/// What is apt to go wrong.
const EDGES: [f64; 18] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    5e-324,
    -5e-324,
    1e-200,
    1e200,
    1e-9,
    f64::EPSILON,
];

/// Any bits, an edge, or a number of ordinary size.
pub fn any(rng: &mut Rng) -> f64 {
    match rng.u8(..8) {
        0 => f64::from_bits(rng.u64(..)),
        1 | 2 => EDGES[rng.usize(..EDGES.len())],
        3 => f64::from(rng.i32(-4..5)),
        _ => 4.0 * rng.f64() - 2.0,
    }
}

/// Of ordinary size, now and then anything.
pub fn sane(rng: &mut Rng) -> f64 {
    if rng.u8(..32) == 0 {
        any(rng)
    } else {
        4.0 * rng.f64() - 2.0
    }
}

/// Anything once in so many times, else what is sane.
pub fn either(rng: &mut Rng, times: u8) -> fn(&mut Rng) -> f64 {
    if rng.u8(..times) == 0 { any } else { sane }
}

pub fn all<const N: usize>(rng: &mut Rng, number: fn(&mut Rng) -> f64) -> [f64; N] {
    core::array::from_fn(|_| number(rng))
}

/// A power of two of any size, mostly one.
pub fn scale(rng: &mut Rng) -> f64 {
    let exponent = if rng.bool() { 0 } else { rng.i32(-1070..1020) };
    f64::powi(2.0, exponent)
}

/// Next to a number, by a few units in the last place.
pub fn beside(number: f64, rng: &mut Rng) -> f64 {
    let steps = u64::from(rng.u8(..8) * rng.u8(..2));
    f64::from_bits(number.to_bits().wrapping_add(steps))
}
