//! Sine and cosine of all lanes at once, with the bits of libm.
//!
//! The steps are those of libm, after fdlibm (`e_rem_pio2.c`, `k_sin.c`, `k_cos.c`): n quarter
//! turns are subtracted in parts, two polynomials give sine and cosine of the remainder, and n mod
//! 4 swaps and negates them. Three kinds of lanes are left to libm. Near a remainder of π/4, libm
//! takes n from the high word of the angle, and this code takes it from rounding. If the remainder
//! is less than 2⁻⁴⁹ of the angle, libm subtracts a third part of π/2. Beyond 10⁶, and for NaN,
//! libm subtracts differently.
//!
//! > Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved. Developed at SunPro, a Sun
//! > Microsystems, Inc. business. Permission to use, copy, modify, and distribute this software is
//! > freely granted, provided that this notice is preserved.

use core::f64::consts::FRAC_2_PI;

use super::arithmetic::{Lanes, Mask};
use super::register::{Register, by_itself};
use crate::numbers::math;
use crate::numbers::scalar::Scalar;

/// The first 33 bits of π/2, and the remainder.
const FIRST: [f64; 2] = [1.570_796_326_734_125_6, 6.077_100_506_506_192e-11];
/// The second 33 bits of π/2, and the remainder.
const SECOND: [f64; 2] = [6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];
/// 3 2⁵¹: adding it to a number rounds the number to an integer, which the last bits then hold.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// Just below π/4: up to 6e-6 from there, the high word of an angle gives n.
const SURE: f64 = 0.785_38;
/// The largest angle.
const LARGEST: f64 = 1e6;

/// The coefficients of (sin x - x) / x³, in powers of x².
const SINE: [f64; 6] = [
    -0.166_666_666_666_666_32,
    0.008_333_333_333_322_49,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
/// The coefficients of (cos x - 1 + x²/2) / x⁴, in powers of x².
const COSINE: [f64; 6] = [
    0.041_666_666_666_666_6,
    -0.001_388_888_888_887_411,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Sine and cosine.
#[cfg_attr(not(unoptimized), inline(always))]
pub(super) fn sin_cos<S: Register>(angle: Lanes<S>) -> (Lanes<S>, Lanes<S>) {
    if Lanes::<S>::COUNT == 1 {
        let (sine, cosine) = math::sin_cos(angle.lane(0));
        return (
            Lanes::splat(angle.simd, sine),
            Lanes::splat(angle.simd, cosine),
        );
    }
    let ((mut sines, mut cosines), settled) = by_itself!(angle.simd, side_by_side(angle));
    if Lanes::agreed(settled) != Some(true) {
        let zero = Lanes::splat(angle.simd, 0.0);
        let left = Lanes::select(settled, zero, angle);
        one_by_one(
            left.as_slice(),
            sines.as_mut_slice(),
            cosines.as_mut_slice(),
        );
    }
    (sines, cosines)
}

/// Sines and cosines of the nonzero angles.
#[cold]
#[inline(never)]
fn one_by_one(angles: &[f64], sines: &mut [f64], cosines: &mut [f64]) {
    for ((angle, sine), cosine) in angles.iter().zip(sines).zip(cosines) {
        if *angle != 0.0 {
            (*sine, *cosine) = math::sin_cos(*angle);
        }
    }
}

/// Sine and cosine, and the lanes in which they have the bits of libm.
#[cfg_attr(not(unoptimized), inline(always))]
fn side_by_side<S: Register>(angle: Lanes<S>) -> ((Lanes<S>, Lanes<S>), Mask<S>) {
    let simd = angle.simd;
    let shifted = angle * number(simd, FRAC_2_PI) + number(simd, ROUND);
    let turns = shifted - number(simd, ROUND);
    let (rest, tail, settled) = subtracted(angle, turns);
    let settled = settled
        & rest.abs().less_or_equal(number(simd, SURE))
        & angle.abs().less_or_equal(number(simd, LARGEST));
    (turned(of_rest(angle, turns, rest, tail), shifted), settled)
}

/// The same number in all lanes.
#[cfg_attr(not(unoptimized), inline(always))]
fn number<S: Register>(simd: S, number: f64) -> Lanes<S> {
    Lanes::splat(simd, number)
}

/// The angle minus n quarter turns, in two parts, and the lanes in which these have the bits of
/// libm.
///
/// A second part of π/2 is subtracted where the exponent falls by more than 16.
#[cfg_attr(not(unoptimized), inline(always))]
fn subtracted<S: Register>(angle: Lanes<S>, turns: Lanes<S>) -> (Lanes<S>, Lanes<S>, Mask<S>) {
    let simd = angle.simd;
    let mut near = angle - turns * number(simd, FIRST[0]);
    let mut correction = turns * number(simd, FIRST[1]);
    let enough = has_kept(angle, near - correction, 65_536.0);
    let mut settled = enough;
    if Lanes::agreed(enough) != Some(true) {
        let part = turns * number(simd, SECOND[0]);
        let nearer = near - part;
        let finer = turns * number(simd, SECOND[1]) - ((near - nearer) - part);
        near = Lanes::select(enough, near, nearer);
        correction = Lanes::select(enough, correction, finer);
        settled = has_kept(angle, near - correction, 562_949_953_421_312.0);
    }
    let rest = near - correction;
    (rest, (near - rest) - correction, settled)
}

/// Whether the exponent of the remainder is at most this much below that of the angle: a power of
/// two.
#[cfg_attr(not(unoptimized), inline(always))]
fn has_kept<S: Register>(angle: Lanes<S>, rest: Lanes<S>, most: f64) -> Mask<S> {
    power(angle).less_or_equal(number(angle.simd, most) * power(rest))
}

/// The power of two in a number.
#[cfg_attr(not(unoptimized), inline(always))]
fn power<S: Register>(of: Lanes<S>) -> Lanes<S> {
    let exponent = of.simd.splat_u64s(0x7ff << 52);
    let bits = of.simd.transmute_u64s_f64s(of.numbers);
    let power = of.simd.and_u64s(bits, exponent);
    Lanes::new(of.simd, of.simd.transmute_f64s_u64s(power))
}

/// Sine and cosine of the remainder of an angle.
#[cfg_attr(not(unoptimized), inline(always))]
fn of_rest<S: Register>(
    angle: Lanes<S>,
    turns: Lanes<S>,
    rest: Lanes<S>,
    tail: Lanes<S>,
) -> (Lanes<S>, Lanes<S>) {
    let simd = angle.simd;
    let (zero, half, one) = (number(simd, 0.0), number(simd, 0.5), number(simd, 1.0));
    let square = rest * rest;
    let cube = square * rest;
    let fourth = square * square;

    let [s1, s2, s3] = [
        number(simd, SINE[0]),
        number(simd, SINE[1]),
        number(simd, SINE[2]),
    ];
    let [s4, s5, s6] = [
        number(simd, SINE[3]),
        number(simd, SINE[4]),
        number(simd, SINE[5]),
    ];
    let series = s2 + square * (s3 + square * s4) + square * fourth * (s5 + square * s6);
    let small = rest + cube * (s1 + square * series);
    let small = Lanes::select(angle.equal(zero), angle, small);
    let large = rest - ((square * (half * tail - cube * series) - tail) - cube * s1);
    let sine = Lanes::select(turns.equal(zero), small, large);

    let [c1, c2, c3] = [
        number(simd, COSINE[0]),
        number(simd, COSINE[1]),
        number(simd, COSINE[2]),
    ];
    let [c4, c5, c6] = [
        number(simd, COSINE[3]),
        number(simd, COSINE[4]),
        number(simd, COSINE[5]),
    ];
    let series = square * (c1 + square * (c2 + square * c3))
        + fourth * fourth * (c4 + square * (c5 + square * c6));
    let fall = half * square;
    let most = one - fall;
    (
        sine,
        most + (((one - most) - fall) + (square * series - rest * tail)),
    )
}

/// The same after n quarter turns, with n in the last bits of a number.
#[cfg_attr(not(unoptimized), inline(always))]
fn turned<S: Register>(
    (sine, cosine): (Lanes<S>, Lanes<S>),
    shifted: Lanes<S>,
) -> (Lanes<S>, Lanes<S>) {
    let simd = sine.simd;
    let (one, two) = (simd.splat_u64s(1), simd.splat_u64s(2));
    let quarters = simd.transmute_u64s_f64s(shifted.numbers);
    let next = simd.add_u64s(quarters, one);
    let odd = has_bit(simd, quarters, one);
    let (across, along) = (
        Lanes::select(odd, cosine, sine),
        Lanes::select(odd, sine, cosine),
    );
    // two of four quarters are negative
    (
        Lanes::select(has_bit(simd, quarters, two), -across, across),
        Lanes::select(has_bit(simd, next, two), -along, along),
    )
}

#[cfg_attr(not(unoptimized), inline(always))]
fn has_bit<S: Register>(simd: S, number: S::u64s, bit: S::u64s) -> Mask<S> {
    let lanes = simd.equal_u64s(simd.and_u64s(number, bit), bit);
    Mask { simd, lanes }
}
