//! Products and sums by each kind of instructions, number by number.
#![cfg(target_arch = "x86_64")]
#![allow(clippy::float_cmp, reason = "rounding is compared")]

use newton_euler::taylor::{Arithmetic, Plain};
use pulp::x86::{V3, V4};

/// Numbers whose products are not doubles.
fn numbers(first: f64) -> [f64; 15] {
    let mut next = first;
    [(); 15].map(|()| {
        next = (next * 3.7 + 0.3) % 2.0 - 1.0;
        next
    })
}

/// Of fifteen numbers, so many are rounded once.
fn check(arithmetic: impl Arithmetic, fused: usize) {
    let [sums, left, right] = [0.1, 0.7, -0.4].map(numbers);
    let found = arithmetic.multiply_add(sums, left, right);
    for k in 0..15 {
        let once = left[k].mul_add(right[k], sums[k]);
        let twice = left[k] * right[k] + sums[k];
        assert_eq!(found[k], if k < fused { once } else { twice }, "{k}");
    }
}

#[test]
fn by_every_processor() {
    check(Plain, 0);
}

#[test]
fn four_at_once() {
    if let Some(proof) = V3::try_new() {
        check(proof, 12);
    }
}

#[test]
fn eight_at_once() {
    if let Some(proof) = V4::try_new() {
        check(proof, 12);
    }
}
