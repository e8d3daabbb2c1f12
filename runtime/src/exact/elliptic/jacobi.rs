//! Jacobi's elliptic functions, from the complementary modulus.
//!
//! The method is the arithmetic-geometric mean: R. Bulirsch, Numerical calculation of elliptic
//! integrals and elliptic functions, Numerische Mathematik 7 (1965) 78. All sums have positive
//! terms, so cn and dn keep their digits where they are small. Motions that pass near a saddle need
//! that.

use core::f64::consts::FRAC_PI_2;

use crate::numbers::math;

/// Means from 1 and k', until they agree to half of their digits; the smallest k' needs 13.
const LEVELS: usize = 14;

/// sn, cn and dn of one argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elliptic {
    /// `sin(am u)`
    pub sn: f64,
    /// `cos(am u)`
    pub cn: f64,
    /// `√(1 - k² sn²)`
    pub dn: f64,
}

/// The elliptic functions of one modulus k, 0 <= k <= 1.
///
/// ```
/// use newton_euler::exact::Jacobi;
///
/// let nearly_one = Jacobi::new(1e-8); // k² = 1 - 1e-16
/// assert!((nearly_one.quarter_period() - (4.0_f64 / 1e-8).ln()).abs() < 1e-14);
/// assert!((nearly_one.at(10.0).dn * 10.0_f64.cosh() - 1.0).abs() < 1e-7);
/// assert!((Jacobi::new(1.0).at(0.5).sn - 0.5_f64.sin()).abs() < 1e-16);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobi {
    complement: f64,
    /// Arithmetic and geometric means.
    levels: [[f64; 2]; LEVELS],
    count: usize,
    /// Their limit.
    mean: f64,
}

impl Jacobi {
    /// From `k' = √(1 - k²)`, between 0 and 1: near a separatrix, k' distinguishes values that k
    /// does not.
    #[must_use]
    pub fn new(complement: f64) -> Self {
        let (mut levels, mut count) = ([[0.0; 2]; LEVELS], 0);
        let [mut arithmetic, mut geometric] = [1.0, complement];
        if complement > 0.0 {
            while count < LEVELS {
                levels[count] = [arithmetic, geometric];
                count += 1;
                let is_last = (arithmetic - geometric).abs() <= 1e-8 * arithmetic;
                let product = arithmetic * geometric;
                arithmetic = 0.5 * (arithmetic + geometric);
                if is_last {
                    break;
                }
                geometric = math::sqrt(product);
            }
        } else {
            arithmetic = 0.0;
        }
        Self {
            complement,
            levels,
            count,
            mean: arithmetic,
        }
    }

    /// k'
    #[must_use]
    pub const fn complement(&self) -> f64 {
        self.complement
    }

    /// K, a quarter of the period of sn; infinite for k = 1.
    #[must_use]
    pub fn quarter_period(&self) -> f64 {
        FRAC_PI_2 / self.mean
    }

    /// `π/(2 K)`: this factor converts arguments to angles, half a turn for half a period. Zero for
    /// k = 1.
    #[must_use]
    pub const fn mean(&self) -> f64 {
        self.mean
    }

    /// sn, cn and dn of an argument of any size.
    #[must_use]
    pub fn at(&self, argument: f64) -> Elliptic {
        if self.is_hyperbolic() {
            return hyperbolic(argument);
        }
        let (sine, cosine) = math::sin_cos(self.mean * argument);
        self.at_angle(sine, cosine)
    }

    /// k = 1: sn is the hyperbolic tangent, and nothing is periodic.
    pub(in crate::exact) fn is_hyperbolic(&self) -> bool {
        self.mean == 0.0
    }

    /// The same for the angle `π u/(2 K)`.
    pub(in crate::exact) fn at_angle(&self, sine: f64, cosine: f64) -> Elliptic {
        if sine.abs() < 1e-140 {
            return Elliptic {
                sn: sine / self.mean,
                cn: f64::signum(cosine),
                dn: 1.0,
            };
        }
        // upwards from k = 0, where sn is the sine: c is the mean times cn/sn
        let mut quotient = cosine / sine;
        let mut c = self.mean * quotient;
        let mut dn = 1.0;
        for [arithmetic, geometric] in self.levels.iter().take(self.count).rev() {
            let square = quotient * c;
            c *= dn;
            dn = (geometric + square) / (arithmetic + square);
            quotient = c / arithmetic;
        }
        let sn = f64::copysign(1.0 / math::sqrt(c * c + 1.0), sine);
        Elliptic { sn, cn: c * sn, dn }
    }

    /// The functions of a sum, from those of two arguments with `cn >= 0`. Among equivalent forms,
    /// the one that does not cancel is used, so cn and dn keep their digits where they are small.
    pub(in crate::exact) fn sum(&self, a: Elliptic, b: Elliptic) -> Elliptic {
        let complement = self.complement;
        let square = (1.0 - complement) * (1.0 + complement);
        let (sines, cosines, rest) = (a.sn * b.sn, a.cn * b.cn, a.dn * b.dn);
        let scale = a.cn * a.cn + (a.sn * b.dn) * (a.sn * b.dn); // 1 - k² sn² sn²
        if scale == 0.0 {
            // for k = 1, an infinite argument: adding to it changes nothing
            return a;
        }
        let sn = (a.sn * b.cn * b.dn + b.sn * a.cn * a.dn) / scale;
        let cn = if sines > 0.5 {
            let [near, far] = [a.cn * b.dn, complement * b.sn.abs()];
            let divisor = cosines + sines * rest; // for k = 1 it comes to nothing
            if divisor == 0.0 {
                0.0
            } else {
                (near - far) * (near + far) / divisor
            }
        } else {
            (cosines - sines * rest) / scale
        };
        let mixed = square * sines * cosines;
        let dn = if mixed > 0.0 {
            (complement * complement + square * cosines * cosines) / (rest + mixed)
        } else {
            (rest - mixed) / scale
        };
        Elliptic { sn, cn, dn }
    }
}

fn hyperbolic(argument: f64) -> Elliptic {
    let secant = 1.0 / math::cosh(argument);
    Elliptic {
        sn: math::tanh(argument),
        cn: secant,
        dn: secant,
    }
}
