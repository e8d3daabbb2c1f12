//! An elliptic integral of the third kind along an argument that increases uniformly.
//!
//! ```text
//! R(u) = ∫₀ᵘ sn²/(1 + m sn²) du = s³/3 R_J(cn², dn², 1, 1 + m s²)      s = sn u
//! ```
//!
//! After the time t, v has been added to the start u, without whole half periods. The addition
//! theorem gives R (P. F. Byrd, M. D. Friedman, Handbook of Elliptic Integrals, 116), so a short
//! time does not get the error of a long one:
//!
//! ```text
//! R(u + v) - R(u) = R(v) + atan(g sn u sn v s/(1 + m - m cn u cn v cn(u + v)))/g
//! s = sn(u + v)      g² = m (1 + m) (m + k²)
//! ```

use core::f64::consts::FRAC_2_PI;

use super::carlson::r_j;
use super::jacobi::{Elliptic, Jacobi};
use super::phase::{Phase, Reading};
use crate::numbers::math;

/// R of one parameter, whose `g²` is not negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::exact) struct ThirdKind {
    /// m
    parameter: f64,
    /// 1 + m
    above: f64,
    /// g
    scale: f64,
    /// `R(K)`; zero for k = 1, where nothing is periodic.
    quarter: f64,
}

impl ThirdKind {
    /// From m, 1 + m and g: each may be known more accurately than it follows from the others.
    pub fn new(jacobi: &Jacobi, [parameter, above, scale]: [f64; 3]) -> Self {
        let last = jacobi.complement();
        Self {
            parameter,
            above,
            scale,
            quarter: if jacobi.is_hyperbolic() {
                0.0
            } else {
                r_j(0.0, last * last, 1.0, above) / 3.0
            },
        }
    }

    /// The mean rate of R \[1/s\]; for k = 1 its rate where sn² = 1, to which it tends.
    pub fn rate(&self, phase: &Phase) -> f64 {
        phase.rate
            * if phase.jacobi.is_hyperbolic() {
                1.0 / self.above
            } else {
                FRAC_2_PI * self.quarter
            }
    }

    /// The growth of R, minus its mean rate times the time.
    pub fn periodic(&self, phase: &Phase, reading: &Reading) -> f64 {
        self.within_quarter(&phase.jacobi, reading.rest)
            + self.step(phase.start, reading.rest, reading.sum)
            - FRAC_2_PI * self.quarter * reading.angle
    }

    /// R within a quarter period of zero; for k = 1 without its part `u/(1 + m)`, and m is not
    /// negative.
    fn within_quarter(&self, jacobi: &Jacobi, Elliptic { sn, cn, dn }: Elliptic) -> f64 {
        let square = sn * sn;
        if jacobi.is_hyperbolic() {
            let root = math::sqrt(self.parameter);
            return -sn * arctangent_ratio(root * sn) / self.above;
        }
        let last = cn * cn + self.above * square;
        sn * square / 3.0 * r_j(cn * cn, dn * dn, 1.0, last)
    }

    /// `R(u + v) - R(u) - R(v)`
    fn step(&self, first: Elliptic, second: Elliptic, sum: Elliptic) -> f64 {
        let sines = first.sn * second.sn * sum.sn;
        let rest = self.above - self.parameter * (first.cn * second.cn * sum.cn);
        if self.scale > 0.0 {
            math::atan2(self.scale * sines, rest) / self.scale
        } else {
            sines / rest
        }
    }
}

/// `atan(x)/x`
fn arctangent_ratio(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { math::atan(x) / x }
}
