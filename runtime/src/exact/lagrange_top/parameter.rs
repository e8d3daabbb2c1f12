//! The parameters of Cayley and Klein of a top.
//!
//! The attitude is α = w + i z and β = x + i y, `|α|² = (1 + u)/2`, `|β|² = (1 - u)/2`: there are
//! no angles, and the vertical is not singular. With s, c, d = sn, cn, dn of λ t + u₀, `|α|² = c₁²
//! (1 + n s²)`, n = (u₂ - u₁)/(1 + u₁), and for β with -(u₂ - u₁)/(1 - u₁); and
//!
//! ```text
//! arg' = ω + σ λ G/(1 + n s²)      ω = ± (ω₃ - p)/2      G² = (1 + n)(1 + κ)      n κ = k²
//! ```
//!
//! where σ is the sign of b ± p. There are two forms. Each has no pole near the real axis where the
//! other one has:
//!
//! ```text
//! |n| < k       c₁ √(1 + n s²) exp i(ω t + σ G λ t - σ G n R)
//!               R = ∫ s²/(1 + n s²) λ dt
//! |κ| <= k      (c₁ c d + i σ c₂ s)/√(1 + κ s²) exp i(ω t + σ G κ R)
//!               R = ∫ s²/(1 + κ s²) λ dt,  c₂ = G c₁
//! ```
//!
//! as `atan(G s/(c d))' = λ G (1/(1 + n s²) + 1/(1 + κ s²) - 1)`. In the second, α may pass through
//! zero.

use nalgebra::Complex;

use crate::exact::elliptic::jacobi::Elliptic;
use crate::exact::elliptic::phase::{Phase, Reading};
use crate::exact::elliptic::third_kind::ThirdKind;
use crate::numbers::math;
use crate::numbers::twofold::Twofold;

/// One of the two, as a function of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Parameter {
    form: Form,
    /// Rotates the form at time zero to the start.
    start: Complex<f64>,
    /// Mean rate of the argument.
    rate: f64,
    /// The factor of R in the argument.
    amplitude: f64,
    third: ThirdKind,
}

/// The factor before the exponential.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Form {
    /// Whether it is the first form.
    is_modulus: bool,
    /// c₁ and σ c₂
    sizes: [f64; 2],
    /// n in the first, κ in the second, and 1 more
    parameter: [f64; 2],
    /// k²
    square: f64,
}

/// The inputs of a parameter.
pub(super) struct Ingredients {
    /// 1 for α, -1 for β
    pub sign: f64,
    /// The distances of u₁, u₂ and, times 2a, u₃ from the pole where the parameter is zero.
    pub distances: [f64; 3],
    /// `u₂ - u₁`
    pub apart: f64,
    /// `2a (u₃ - u₁)`
    pub span: f64,
    /// 2a
    pub twice: f64,
    /// b ± p
    pub about: f64,
    /// ω
    pub rate: f64,
    /// sn, cn and dn at time zero.
    pub first: Elliptic,
    /// The parameter and its velocity at time zero.
    pub start: [Complex<f64>; 2],
}

impl Parameter {
    pub fn new(given: &Ingredients, phase: &Phase) -> Self {
        let Ingredients {
            sign,
            distances: [first, second, third],
            apart,
            span,
            twice,
            ..
        } = *given;
        let direction = f64::copysign(1.0, given.about);
        let sizes = [
            math::sqrt(0.5 * first),
            direction * math::sqrt(0.5 * second * (third / span)),
        ];
        // |n| < |κ|, by 1 + n and 1 + κ: near -1 these have the digits
        let [of_first, of_second] = [second * span, third * first];
        let is_modulus = sign * of_first < sign * of_second;
        let [parameter, above, amplitude] = if is_modulus {
            let n = sign * apart / first;
            [n, second / first, -n * sizes[1] / sizes[0]]
        } else {
            let beyond = sign * twice / span;
            [
                beyond * first,
                third / span,
                2.0 * beyond * sizes[0] * sizes[1],
            ]
        };
        let third = if amplitude == 0.0 {
            ThirdKind::new(&phase.jacobi, [0.0, 1.0, 0.0])
        } else {
            ThirdKind::new(&phase.jacobi, [parameter, above, amplitude.abs()])
        };
        let steady = if is_modulus {
            given.rate + 0.5 * math::sqrt(span) * (sizes[1] / sizes[0])
        } else {
            given.rate
        };
        let form = Form {
            is_modulus,
            sizes,
            parameter: [parameter, above],
            square: twice * apart / span,
        };
        let [value, velocity] = form.at(given.first);
        let start = given.start[0] * value.conj() + given.start[1] * velocity.conj();
        let size = math::hypot(start.re, start.im);
        Self {
            form,
            start: if size > 0.0 {
                start / size
            } else {
                Complex::new(1.0, 0.0)
            },
            rate: steady + amplitude * third.rate(phase),
            amplitude,
            third,
        }
    }

    /// The same motion in another unit of time.
    pub fn faster(self, exponent: i32) -> Self {
        Self {
            rate: libm::scalbn(self.rate, exponent),
            ..self
        }
    }

    /// The parameter and its velocity.
    pub fn at(&self, time: f64, phase: &Phase, reading: &Reading) -> [Complex<f64>; 2] {
        let mut argument = Twofold::product(self.rate, time);
        if self.amplitude != 0.0 {
            argument =
                argument + Twofold::from(self.amplitude * self.third.periodic(phase, reading));
        }
        let (sine, cosine) = argument.sin_cos();
        let turn = self.start * Complex::new(cosine, sine);
        self.form.at(reading.elliptic()).map(|part| part * turn)
    }
}

impl Form {
    /// The factor, and that of the velocity: of `(± u' + i (b ± p))/(4 λ α*)`.
    fn at(&self, Elliptic { sn, cn, dn }: Elliptic) -> [Complex<f64>; 2] {
        let [near, far] = self.sizes;
        let [parameter, above] = self.parameter;
        let product = cn * dn;
        let root = math::sqrt(cn * cn + above * (sn * sn));
        // on the separatrix, after a long time
        let inverse = if root > 0.0 { 1.0 / root } else { 0.0 };
        if self.is_modulus {
            let velocity = Complex::new(near * parameter * sn * product, far);
            [Complex::new(near * root, 0.0), velocity * inverse]
        } else {
            let along = above + self.square * (cn * cn);
            let value = Complex::new(near * product, far * sn);
            let velocity = Complex::new(-near * sn * along, far * product);
            [value * inverse, velocity * inverse]
        }
    }
}
