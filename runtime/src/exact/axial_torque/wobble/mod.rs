//! Rotation about a vector that sweeps slowly: precession about the vector, and a wobble that
//! follows it.
//!
//! With T the turn from the third axis to `(w, 0, u) = λ (s, 0, c)`, and `ε = b/λ²`, the rotation P
//! is, up to exponentially small terms in `1/ε`,
//!
//! ```text
//! P = const exp(k Ψ/2) (1 + z i)/|1 + z i| T*      Ψ' = λ (1 - s ε Re z)
//! z'/λ = -(k ε s/2) (1 - z²) - k z                 ε' = -2 λ c ε²      c' = λ s² ε
//! ```
//!
//! where z is complex, of the unit k. By powers of ε,
//!
//! ```text
//! z = s Σ k^(n-1) B_n(c) ε^n      B_1 = -1/2
//! B_n = (1 - c²) (B_(n-1)' - 1/2 Σ B_k B_(n-1-k)) - (2n - 1) c B_(n-1)
//! Ψ = ∫ λ dt + Σ K_m(c) (ε/(1 + c))^m, over odd m
//! (1 - c) K_m' - m K_m = (-1)^((m+1)/2) (1 - c) (1 + c)^m B_m
//! ```
//!
//! for c from 0 to 1. The correction to the integral vanishes far out, and is odd in c.

mod coefficients;

use coefficients::{LAG, ORDER, TILT};

/// Real and imaginary part of z, from c, s and ε.
pub(super) fn tilt(cosine: f64, sine: f64, ratio: f64) -> [f64; 2] {
    let square = cosine * cosine;
    let (mut real, mut imaginary, mut power) = (0.0, 0.0, sine);
    for (n, coefficients) in TILT.iter().take(orders(ratio)).enumerate() {
        power *= ratio;
        let odd = n % 2;
        let polynomial = coefficients.iter().take(n + 1).skip(odd).step_by(2).rev();
        let even_part = polynomial.fold(0.0, |sum, coefficient| sum * square + coefficient);
        let size = power
            * if odd == 1 {
                cosine * even_part
            } else {
                even_part
            };
        let part = if odd == 1 { &mut imaginary } else { &mut real };
        *part += if n % 4 < 2 { size } else { -size };
    }
    [real, imaginary]
}

/// `Ψ - ∫ λ dt`, from |c| and ε.
pub(super) fn lag(cosine: f64, ratio: f64) -> f64 {
    let factor = ratio / (1.0 + cosine);
    let (square, mut power, mut sum) = (factor * factor, factor, 0.0);
    for (k, coefficients) in LAG.iter().take(orders(ratio).div_ceil(2)).enumerate() {
        let degree = 4 * k + 2;
        let polynomial = coefficients.iter().take(degree + 1).rev();
        sum += power * polynomial.fold(0.0, |sum, coefficient| sum * cosine + coefficient);
        power *= square;
    }
    sum
}

/// The number of orders that matter: `B_n` is `(2n - 1)!!/2` at most.
fn orders(ratio: f64) -> usize {
    let (mut bound, mut odd, mut n) = (0.5, 1.0, 0);
    while n < ORDER && bound > 1e-18 {
        bound *= odd * ratio;
        odd += 2.0;
        n += 1;
    }
    n
}
