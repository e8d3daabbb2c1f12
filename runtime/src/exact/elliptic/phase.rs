//! An elliptic argument that increases uniformly in time.

use core::f64::consts::{FRAC_1_PI, PI};

use super::jacobi::{Elliptic, Jacobi};
use crate::numbers::math;
use crate::numbers::twofold::Twofold;

/// π minus the nearest double.
const PI_REST: f64 = 1.224_646_799_147_353_2e-16;

/// `u = u₀ + λ t`, where sn, cn and dn of u₀ are known: the addition theorem replaces the inversion
/// of an integral.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::exact) struct Phase {
    pub jacobi: Jacobi,
    /// The functions of u₀, or of u₀ minus half a period: within a quarter period of zero.
    pub start: Elliptic,
    /// Whether half a period was subtracted.
    is_opposite: bool,
    /// Rate of the angle `π u/(2 K)`, and for k = 1 of u itself \[rad/s\].
    pub rate: f64,
}

/// `u - u₀`, and the functions of u.
pub(in crate::exact) struct Reading {
    /// Half periods in it.
    pub halves: f64,
    /// The functions of the remainder v, within a quarter period of zero.
    pub rest: Elliptic,
    /// v as an angle \[rad\]; for k = 1, v itself.
    pub angle: f64,
    /// The functions of `start + v`.
    pub sum: Elliptic,
    /// Whether u is an odd number of half periods beyond `start + v`.
    is_opposite: bool,
}

impl Phase {
    /// The functions at time zero, and the rate λ of the argument.
    pub fn new(jacobi: Jacobi, start: Elliptic, rate: f64) -> Self {
        let is_opposite = start.cn < 0.0;
        let scale = if jacobi.is_hyperbolic() {
            1.0
        } else {
            jacobi.mean()
        };
        Self {
            jacobi,
            start: if is_opposite { start.opposite() } else { start },
            is_opposite,
            rate: rate * scale,
        }
    }

    /// The same motion in another unit of time.
    pub fn faster(self, exponent: i32) -> Self {
        Self {
            rate: libm::scalbn(self.rate, exponent),
            ..self
        }
    }

    /// The argument at a time \[s\]. Half periods are subtracted in twice the precision.
    pub fn at(&self, time: f64) -> Reading {
        let phase = Twofold::product(self.rate, time);
        let (halves, angle, rest) = if self.jacobi.is_hyperbolic() {
            let angle = phase.value();
            (0.0, angle, self.jacobi.at(angle))
        } else {
            let halves = math::floor(phase.value() * FRAC_1_PI + 0.5);
            let angle = (phase - Twofold::product(PI, halves)).value() - PI_REST * halves;
            let (sine, cosine) = math::sin_cos(angle);
            (halves, angle, self.jacobi.at_angle(sine, cosine))
        };
        let is_odd = halves - 2.0 * math::floor(0.5 * halves) > 0.5;
        Reading {
            halves,
            rest,
            angle,
            sum: self.jacobi.sum(self.start, rest),
            is_opposite: is_odd != self.is_opposite,
        }
    }
}

impl Reading {
    /// The functions of u.
    pub fn elliptic(&self) -> Elliptic {
        if self.is_opposite {
            self.sum.opposite()
        } else {
            self.sum
        }
    }

    /// am u, from that of the start, minus half a turn if that was subtracted.
    pub fn amplitude(&self) -> f64 {
        let Elliptic { sn, cn, .. } = self.sum;
        let carried = if cn < 0.0 {
            f64::copysign(PI, self.angle) + math::atan2(-sn, -cn)
        } else {
            math::atan2(sn, cn)
        };
        carried + PI * self.halves
    }
}

impl Elliptic {
    /// Half a period further on.
    fn opposite(self) -> Self {
        Self {
            sn: -self.sn,
            cn: -self.cn,
            dn: self.dn,
        }
    }
}
