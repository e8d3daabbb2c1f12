//! Carlson's symmetric elliptic integral of the third kind.
//!
//! B. C. Carlson, Numerical computation of real or complex elliptic integrals, Numerical Algorithms
//! 10 (1995) 13; NIST Digital Library of Mathematical Functions, 19.36(i).

use crate::numbers::math;
use crate::numbers::scale;

/// `R_J(x, y, z, p) = (3/2) ∫₀^∞ dt / ((t + p) √((t + x)(t + y)(t + z)))`.
///
/// x, y and z are not negative, and p is positive; the integral is infinite if two of x, y, z are
/// zero, or p is. It is computed by duplication: each step brings all arguments four times nearer
/// to each other. Then the Taylor series is summed up to terms of seventh order.
///
/// ```
/// use newton_euler::exact::r_j;
///
/// assert!((r_j(2.0, 3.0, 4.0, 5.0) - 0.142_975_796_671_567_54).abs() < 1e-16);
/// assert!((r_j(0.0, 1.0, 2.0, 3.0) - 0.776_886_237_785_823_32).abs() < 4e-16);
/// ```
#[must_use]
pub fn r_j(x: f64, y: f64, z: f64, p: f64) -> f64 {
    if [x + y, y + z, z + x, p].contains(&0.0) {
        return f64::INFINITY;
    }
    let largest = math::max(math::max(x, y), math::max(z, p));
    if largest == f64::INFINITY {
        return 1.0 / (x + y + z + p);
    }
    if largest > 0.0 && !(1e-90..1e90).contains(&largest) {
        // R_J(4ⁿ x, ..) = 8⁻ⁿ R_J(x, ..)
        let n = scale::exponent(largest) / 2;
        let [x, y, z, p] = [x, y, z, p].map(|argument| libm::scalbn(argument, -2 * n));
        return libm::scalbn(r_j(x, y, z, p), -3 * n);
    }
    let [mut x, mut y, mut z, mut p] = [x, y, z, p];
    let mut center = (x + y + z + 2.0 * p) / 5.0;
    let [dx, dy, dz] = [x, y, z].map(|argument| center - argument);
    // 2⁻⁵⁴ to the power of -1/8
    let mut distance = 108.0 * f64::max(dx.abs().max(dy.abs()), dz.abs().max((center - p).abs()));
    let mut apart = (p - x) * (p - y) * (p - z);
    let (mut sum, mut scale) = (0.0, 1.0);
    while distance >= center && center > 0.0 {
        let [a, b, c, d] = [x, y, z, p].map(math::sqrt);
        let mixed = a * b + (a + b) * c;
        let divisor = (d + a) * (d + b) * (d + c);
        sum += scale / divisor * r_c(apart / (divisor * divisor));
        [x, y, z, p] = [x, y, z, p].map(|argument| 0.25 * (argument + mixed));
        center = 0.25 * (center + mixed);
        distance *= 0.25;
        scale *= 0.25;
        apart *= 1.0 / 64.0;
    }
    let [x, y, z] = [dx, dy, dz].map(|difference| difference * scale / center);
    let p = -0.5 * (x + y + z);
    let (product, square) = (x * y * z, p * p);
    let e2 = x * y + x * z + y * z - 3.0 * square;
    let e3 = product + 2.0 * e2 * p + 4.0 * p * square;
    let e4 = (2.0 * product + e2 * p + 3.0 * p * square) * p;
    let e5 = product * square;
    let series = 1.0
        + e2 * (-3.0 / 14.0 + e2 * (9.0 / 88.0 - e2 / 16.0))
        + e3 * (1.0 / 6.0 - 9.0 / 52.0 * e2 + 3.0 / 40.0 * e3 + 45.0 / 272.0 * e2 * e2)
        + e4 * (-3.0 / 22.0 + 3.0 / 20.0 * e2 - 9.0 / 68.0 * e3)
        + e5 * (3.0 / 26.0 - 9.0 / 68.0 * e2);
    scale * series / (center * math::sqrt(center)) + 6.0 * sum
}

/// `R_C(1, 1 + e)`, `e > -1`: `atan(√e)/√e`.
fn r_c(e: f64) -> f64 {
    if e.abs() < 0.01 {
        // the series of 1/(2 n + 1) alternates: the remainder is below 2⁻⁵³
        let divisors = [15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0];
        let sum = divisors
            .iter()
            .fold(1.0 / 17.0, |sum, divisor| 1.0 / divisor - e * sum);
        return 1.0 - e * sum;
    }
    let root = math::sqrt(e.abs());
    if e > 0.0 {
        math::atan(root) / root
    } else {
        0.5 * math::ln((1.0 + root) / (1.0 - root)) / root
    }
}
