//! Random states of all sizes, and special states.

use fastrand::Rng;

use crate::description::body::{Body, Motion};
use crate::given::Given;

/// States that one set of parameters is asked in.
pub const RUN: usize = 64;

/// Where a run of states of a body comes from.
pub fn of_run(seed: u64, body: usize, run: usize) -> Rng {
    let [body, run] = [body, run].map(|number| number as u64);
    Rng::with_seed((seed << 48 ^ body << 32 ^ run).wrapping_mul(0x9E37_79B9_7F4A_7C15))
}

/// Fills in new time, state, inputs and motion.
pub fn draw(random: &mut Rng, body: &Body, given: &mut Given) {
    given.time = if random.u32(..8) == 0 {
        0.0
    } else {
        100.0 * random.f64()
    };
    let (_, inputs) = body.input_offsets();
    given.inputs.clear();
    given
        .inputs
        .extend((0..inputs).map(|_| number(random, 1.0)));
    given.motion.clear();
    given
        .motion
        .extend((0..body.freedoms()).map(|_| number(random, 10.0)));

    given.own.clear();
    let own = body.rates.iter().map(|_| number(random, 1.0));
    given.own.extend(own);
    let state = &mut given.state;
    state.clear();
    match body.motion {
        Motion::Spatial => {
            vector(random, 10.0, state);
            attitude(random, state);
            vector(random, 10.0, state);
            vector(random, 5.0, state);
        }
        Motion::Rotation | Motion::FixedPoint(_) => {
            attitude(random, state);
            vector(random, 5.0, state);
        }
        Motion::Translation => {
            vector(random, 10.0, state);
            vector(random, 10.0, state);
        }
        Motion::Planar => {
            state.extend([number(random, 10.0), number(random, 10.0), angle(random)]);
            state.extend([
                number(random, 10.0),
                number(random, 10.0),
                number(random, 5.0),
            ]);
        }
        Motion::PlanarTranslation => state.extend([(); 4].map(|()| number(random, 10.0))),
        Motion::Pivot(_) | Motion::FixedAxis(..) => {
            state.extend([angle(random), number(random, 5.0)]);
        }
        Motion::Rod(_) => {
            vector(random, 10.0, state);
            let [axis, rate] = line(random);
            state.extend(axis);
            vector(random, 10.0, state);
            state.extend(rate);
        }
    }
}

/// The defaults, and what is within a twentieth of them.
pub fn draw_params(random: &mut Rng, body: &Body, given: &mut Given) {
    given.params = body.defaults();
    if random.u32(..4) > 0 {
        for param in &mut given.params {
            *param *= 0.95 + 0.1 * random.f64();
        }
    }
}

/// Of either sign, about this size or by decades smaller and larger, or zero.
fn number(random: &mut Rng, size: f64) -> f64 {
    let sign = if random.bool() { size } else { -size };
    match random.u32(..16) {
        0 | 1 => 0.0,
        2 => sign,
        3..6 => sign * 10.0_f64.powf(8.0 * random.f64() - 5.0),
        _ => sign * random.f64(),
    }
}

fn vector(random: &mut Rng, size: f64, list: &mut Vec<f64>) {
    let size = match random.u32(..16) {
        0 => 0.0,
        1..4 => size * 10.0_f64.powf(6.0 * random.f64() - 4.0),
        _ => size,
    };
    list.extend([(); 3].map(|()| number(random, size)));
}

fn angle(random: &mut Rng) -> f64 {
    let quarters = f64::from(random.i32(-8..=8));
    match random.u32(..8) {
        0 => 0.0,
        1 => quarters * std::f64::consts::FRAC_PI_2,
        2 => 1e3 * (random.f64() - 0.5),
        3 => 1e-4 * (random.f64() - 0.5),
        _ => 14.0 * (random.f64() - 0.5),
    }
}

/// Of any length but zero.
fn direction<const N: usize>(random: &mut Rng) -> [f64; N] {
    loop {
        let parts = [(); N].map(|()| 2.0 * random.f64() - 1.0);
        let square: f64 = parts.iter().map(|x| x * x).sum();
        if square > 1e-4 && square <= 1.0 {
            return unit(parts);
        }
    }
}

fn unit<const N: usize>(parts: [f64; N]) -> [f64; N] {
    let norm = parts.iter().map(|x| x * x).sum::<f64>().sqrt();
    parts.map(|x| x / norm)
}

/// The scalar of the quaternion last: anywhere, near the identity, upside down, along axes.
fn attitude(random: &mut Rng, list: &mut Vec<f64>) {
    let root = std::f64::consts::FRAC_1_SQRT_2;
    let small = 10.0_f64.powf(-8.0 * random.f64());
    let [x, y, z]: [f64; 3] = direction(random);
    let mut quaternion = match random.u32(..10) {
        0 => [0.0, 0.0, 0.0, 1.0],
        1 => [1.0, 0.0, 0.0, 0.0],
        2 => [root, 0.0, 0.0, root],
        3 => [0.5; 4],
        4 => unit([small * x, small * y, small * z, 1.0]),
        5 => unit([x, y, z, small]),
        _ => direction(random),
    };
    random.shuffle(&mut quaternion[..3]);
    if random.bool() {
        quaternion = quaternion.map(|part| -part);
    }
    list.extend(quaternion);
}

/// The axis of a rod and its rate, across it.
fn line(random: &mut Rng) -> [[f64; 3]; 2] {
    let axis: [f64; 3] = match random.u32(..6) {
        0 => [1.0, 0.0, 0.0],
        1 => [0.0, 0.0, -1.0],
        _ => direction(random),
    };
    let mut rate = [(); 3].map(|()| number(random, 3.0));
    // twice, since what is left the first time may be much shorter than what is taken away
    for _ in 0..2 {
        let along: f64 = rate.iter().zip(&axis).map(|(r, u)| r * u).sum();
        for (r, u) in rate.iter_mut().zip(&axis) {
            *r -= along * u;
        }
    }
    [axis, rate]
}
