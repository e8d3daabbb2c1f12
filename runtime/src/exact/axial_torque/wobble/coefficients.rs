//! The polynomials of the expansion, computed by the compiler.
#![expect(clippy::cast_precision_loss, reason = "small whole numbers")]

/// The highest power of ε: for ε below 1/81 the omitted terms are below 1e-16.
pub(super) const ORDER: usize = 20;

/// `B_n`, by powers of c, for n = 1, 2, ...
pub(super) static TILT: [[f64; ORDER]; ORDER] = tilt();
/// `K_m`, by powers of c, for m = 1, 3, ...
pub(super) static LAG: [[f64; 2 * ORDER]; ORDER / 2] = lag(&tilt());

const fn tilt() -> [[f64; ORDER]; ORDER] {
    let mut all = [[0.0; ORDER]; ORDER];
    all[0][0] = -0.5;
    let mut n = 2;
    while n <= ORDER {
        let before = all[n - 2];
        // B' - 1/2 Σ B_k B_l
        let mut inner = [0.0; ORDER];
        let mut j = 0;
        while j + 2 < n {
            inner[j] = (j + 1) as f64 * before[j + 1];
            let mut k = 1;
            while k + 1 < n {
                let (one, other) = (all[k - 1], all[n - 2 - k]);
                let mut i = 0;
                while i <= j {
                    inner[j] -= 0.5 * one[i] * other[j - i];
                    i += 1;
                }
                k += 1;
            }
            j += 1;
        }
        let mut j = 0;
        while j < n {
            let mut sum = inner[j];
            if j >= 1 {
                sum -= (2 * n - 1) as f64 * before[j - 1];
            }
            if j >= 2 {
                sum -= inner[j - 2];
            }
            all[n - 1][j] = sum;
            j += 1;
        }
        n += 1;
    }
    all
}

const fn lag(tilts: &[[f64; ORDER]; ORDER]) -> [[f64; 2 * ORDER]; ORDER / 2] {
    let mut all = [[0.0; 2 * ORDER]; ORDER / 2];
    let mut m = 1;
    while m < ORDER {
        let mut right = [0.0; 2 * ORDER];
        let sign = if m % 4 == 1 { -1.0 } else { 1.0 };
        let mut j = 0;
        while j < m {
            right[j] = sign * tilts[m - 1][j];
            j += 1;
        }
        right = times_sum(right, -1.0);
        let mut k = 0;
        while k < m {
            right = times_sum(right, 1.0);
            k += 1;
        }
        // the coefficients of c^j: (j + 1) K_(j+1) - (j + m) K_j = right_j
        let mut above = 0.0;
        let mut j = 2 * ORDER;
        while j > 0 {
            j -= 1;
            all[m / 2][j] = (above - right[j]) / (j + m) as f64;
            above = j as f64 * all[m / 2][j];
        }
        m += 2;
    }
    all
}

/// A polynomial times `1 + factor c`.
const fn times_sum(mut polynomial: [f64; 2 * ORDER], factor: f64) -> [f64; 2 * ORDER] {
    let mut j = 2 * ORDER - 1;
    while j > 0 {
        polynomial[j] += factor * polynomial[j - 1];
        j -= 1;
    }
    polynomial
}
