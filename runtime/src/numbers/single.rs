//! Sine and cosine in single precision without doubles, which small processors compute in software.
//!
//! Multiples of π/2 are subtracted in four parts (W. Cody, W. Waite, "Software manual for the
//! elementary functions", 1980); the first three times a multiple are exact. From [`LARGEST`] on,
//! they are subtracted in integers, with as many digits of 2/π as are needed (M. Payne, R. Hanek,
//! ACM SIGNUM Newsletter 18 (1983) 19). The polynomials are those of S. Moshier's Cephes library.
//! Errors are below 0.85 units in the last place, for angles of any size
//! (`tests/scalars/single.rs`).

use core::f32::consts::FRAC_2_PI;

/// π/2 in parts: 8, 11 and 10 bits, and the remainder.
const PARTS: [f32; 4] = [1.570_312_5, 4.837_513e-4, 7.549_533_6e-8, 2.563_344e-12];
/// Up to this, 8192 π/2, the first parts times a multiple are exact.
const LARGEST: f32 = 12_800.0;
/// Up to this, the sine rounds to the angle, and the cosine to one.
const SMALLEST: f32 = 2.4e-4;
/// 3 2²²: adding it to a number rounds the number to an integer, which the last bits then hold.
const ROUND: f32 = 12_582_912.0;

/// The binary digits of 2/π, 32 at a time, after 32 zeros.
const DIGITS: [u32; 8] = [
    0,
    0xa2f9_836e,
    0x4e44_1529,
    0xfc27_57d1,
    0xf534_ddc0,
    0xdb62_9599,
    0x3c43_9041,
    0xfe51_63ab,
];
/// π/2 times 2³¹.
const HALF_PI: u64 = 0xc90f_daa2;

/// Sine and cosine.
pub(crate) fn sin_cos(angle: f32) -> (f32, f32) {
    if angle.abs() < SMALLEST {
        return (angle, 1.0);
    }
    let (turns, rest, tail) = if angle.abs() < LARGEST {
        by_parts(angle)
    } else if angle.is_finite() {
        by_digits(angle)
    } else {
        return (f32::NAN, f32::NAN);
    };
    let (sine, cosine) = of_rest(rest, tail);
    let (sine, cosine) = if turns & 1 == 0 {
        (sine, cosine)
    } else {
        (cosine, sine)
    };
    let sign = |negative: u32, value: f32| f32::from_bits(value.to_bits() ^ (negative << 31));
    (
        sign((turns >> 1) & 1, sine),
        sign(((turns + 1) >> 1) & 1, cosine),
    )
}

pub(crate) fn sin(angle: f32) -> f32 {
    sin_cos(angle).0
}

pub(crate) fn cos(angle: f32) -> f32 {
    sin_cos(angle).1
}

/// The number of quarter turns, modulo four, and the angle that is left, in two parts.
fn by_parts(angle: f32) -> (u32, f32, f32) {
    let shifted = angle * FRAC_2_PI + ROUND;
    let turns = shifted - ROUND;
    let near = (angle - turns * PARTS[0]) - turns * PARTS[1];
    let third = turns * PARTS[2];
    let rest = near - third;
    let tail = ((near - rest) - third) - turns * PARTS[3];
    // ROUND has zeros in its last bits
    (shifted.to_bits() & 3, rest, tail)
}

/// The same for a large angle.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "of each integer 24 digits are left"
)]
fn by_digits(angle: f32) -> (u32, f32, f32) {
    let bits = angle.to_bits();
    let mantissa = u64::from((bits & 0x7f_ffff) | 0x80_0000);
    // digits before this one give whole turns; 150 is the exponent bias of the mantissa as an
    // integer
    let first = ((bits >> 23) & 0xff) + 30 - 150;
    let (word, shift) = ((first / 32) as usize, first % 32);
    let digits = |place: usize| {
        let at = |place: usize| u64::from(DIGITS.get(place).copied().unwrap_or(0));
        (((at(place) << 32) | at(place + 1)) << shift) >> 32
    };
    // quarter turns: two digits before the point, 62 after it
    let product = ((mantissa * digits(word)) << 32)
        .wrapping_add(mantissa * digits(word + 1))
        .wrapping_add((mantissa * digits(word + 2)) >> 32);
    let turns = (product.wrapping_add(1 << 61) >> 62) as u32;
    let rest = product.wrapping_sub(u64::from(turns) << 62).cast_signed();
    let size = rest.unsigned_abs() | 1;
    let zeros = size.leading_zeros();
    let size = ((size << zeros) >> 32) * HALF_PI;
    let power = |exponent: u32| f32::from_bits((127 - exponent - zeros) << 23);
    let [high, low] = [
        (size >> 40) as u32 as f32 * power(21),
        ((size >> 16) as u32 & 0xff_ffff) as f32 * power(45),
    ];
    let sign = if rest < 0 { -1.0 } else { 1.0 };
    if angle < 0.0 {
        (turns.wrapping_neg() & 3, -sign * high, -sign * low)
    } else {
        (turns, sign * high, sign * low)
    }
}

/// Sine and cosine of an angle up to π/4.
fn of_rest(rest: f32, tail: f32) -> (f32, f32) {
    let square = rest * rest;
    let half = 0.5 * square;
    let one = 1.0 - half;
    let quartic = (2.443_315_7e-5 * square - 1.388_731_6e-3) * square + 4.166_664_6e-2;
    let cosine = one + (((1.0 - one) - half) + (square * square * quartic - rest * tail));
    let cubic = (-1.951_529_6e-4 * square + 8.332_161e-3) * square - 0.166_666_55;
    let sine = rest + (rest * square * cubic + tail * cosine);
    (sine, cosine)
}
