//! Free rotation of a body with three different moments of inertia.
//!
//! L. D. Landau, E. M. Lifshitz, Mechanics, § 37; R. van Zon, J. Schofield, J. Comput. Phys. 225
//! (2007) 145. The forms here do not cancel, so no accuracy is lost near the separatrix. Axes are
//! principal: 2 is that of the intermediate moment, 3 the one that the angular momentum m circles,
//! with the largest or the smallest moment; `m₃ > 0`. With G = |m|, T the kinetic energy,
//! `D_ij = |I_i - I_j|`:
//!
//! ```text
//! ω = (W₁ cn u, W₂ sn u, W₃ dn u)           u = λ t + u₀
//! E₁ = I₂ D₁₂ ω₂² + I₃ D₁₃ ω₃²                E₃ = I₁ D₁₃ ω₁² + I₂ D₂₃ ω₂²
//! W₁² = E₃/(I₁ D₁₃)       W₂² = E₃/(I₂ D₂₃)       W₃² = E₁/(I₃ D₁₃)
//! λ² = D₂₃ E₁/(I₁ I₂ I₃), λ of the sign of I₃ - I₂       k² = D₁₂ E₃/(D₂₃ E₁)
//! k'² = (D₁₃/D₂₃) (a + b) (a - b)/E₁      a² = I₃ D₂₃ ω₃²,  b² = I₁ D₁₂ ω₁²
//! ```
//!
//! Attitude: A(m) is the shortest rotation of m to axis 3, and the remainder is a rotation about
//! the angular momentum, which is constant in space,
//!
//! ```text
//! q(t) = q(0) A(m(0))⁻¹ exp(χ e₃) A(m(t))       χ' = (2 T + G ω₃)/(G + m₃)
//! ```
//!
//! χ' is positive and smooth in all motions, so nothing has to be unwrapped. A Landen
//! transformation to the modulus `k₁ = (1 - k')/(1 + k')` makes it a function of sn² alone, with
//! `p² = k₁ (I₁ W₁/(G + I₃ W₃))²`, s = sn(u₁, k₁):
//!
//! ```text
//! χ = χ'(dn = 1) t + C (R(u₁(t)) - R(u₁(0)))     u₁ = u/(1 + k₁)
//! R = ∫ s²/(1 + p² s²) du₁ = s³/3 R_J(cn², dn², 1, 1 + p² s²)
//! C = 2 k₁ W₃ E₃/((G + I₃ W₃)² |λ|/(1 + k₁))
//! ```
//!
//! [`ThirdKind`] computes R and its growth.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::exact::elliptic::jacobi::{Elliptic, Jacobi};
use crate::exact::elliptic::phase::Phase;
use crate::exact::elliptic::third_kind::ThirdKind;
use crate::mechanics::attitude;
use crate::numbers::math;
use crate::numbers::scale;
use crate::numbers::twofold::Twofold;
use crate::state::Rotation;

/// The motion from one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Circling {
    /// Takes components along the axes 1, 2, 3 to body axes.
    axes: Matrix3<f64>,
    /// `q(0) A(m(0))⁻¹`
    start: UnitQuaternion<f64>,
    /// u₁
    phase: Phase,
    /// k'
    complement: f64,
    /// k₁
    modulus: f64,
    /// W
    rates: Vector3<f64>,
    /// Their parts of the angular momentum, over G.
    directions: Vector3<f64>,
    /// Mean of χ'.
    precession: f64,
    /// C
    amplitude: f64,
    /// R
    third: ThirdKind,
}

/// The axes 1, 2, 3, and the components along them.
struct Arranged {
    axes: Matrix3<f64>,
    moments: [f64; 3],
    rates: Vector3<f64>,
    /// `√(a + b)` and `√(a - b)`
    roots: [f64; 2],
    /// The sign of `I₃ - I₂`.
    sign: f64,
}

/// Principal axes by ascending moments, right-handed, `ω₃ >= 0`; 1 and 3 are exchanged if ω
/// circles the axis of the least moment.
fn arrange(moments: [f64; 3], principal: &Matrix3<f64>, w: &Vector3<f64>) -> Arranged {
    let size = |along: f64, from: f64, rate: f64| {
        let moment = Twofold::from(along) * Twofold::sum(along, -from);
        let moment = if moment.value() < 0.0 {
            -moment
        } else {
            moment
        };
        moment.sqrt() * Twofold::from(rate.abs())
    };
    let ([i, j, k], [x, y, z]) = (moments, <[[f64; 3]; 3]>::from(*principal));
    let [least, middle, largest] = ascending([(i, x.into()), (j, y.into()), (k, z.into())]);
    let size_of = |(moment, axis): (f64, Vector3<f64>)| size(moment, middle.0, axis.dot(w));
    let (of_least, of_largest) = (size_of(least), size_of(largest));
    let difference = (of_largest - of_least).value();
    let sign = if difference < 0.0 { -1.0 } else { 1.0 };
    let [mut first, mut second, mut third] = if difference < 0.0 {
        [largest, middle, least]
    } else {
        [least, middle, largest]
    };
    let is_right_handed = first.1.cross(&second.1).dot(&third.1) > 0.0;
    if !is_right_handed {
        first.1 = -first.1;
    }
    if third.1.dot(w) < 0.0 {
        second.1 = -second.1;
        third.1 = -third.1;
    }
    let axes = Matrix3::from([first.1.into(), second.1.into(), third.1.into()]);
    Arranged {
        axes,
        moments: [first.0, second.0, third.0],
        rates: axes.tr_mul(w),
        roots: [(of_largest + of_least).value(), difference.abs()].map(math::sqrt),
        sign,
    }
}

/// Moments over a power of two.
fn of_order_one(moments: [f64; 3]) -> [f64; 3] {
    let heaviest = moments.into_iter().fold(0.0, f64::max);
    let exponent = scale::exponent(heaviest);
    moments.map(|moment| libm::scalbn(moment, -exponent))
}

/// Moments and what belongs to them, in order.
fn ascending<A>([a, b, c]: [(f64, A); 3]) -> [(f64, A); 3] {
    let in_order = |a: (f64, A), b: (f64, A)| if b.0 < a.0 { (b, a) } else { (a, b) };
    let (a, b) = in_order(a, b);
    let (b, c) = in_order(b, c);
    let (a, b) = in_order(a, b);
    [a, b, c]
}

impl Circling {
    /// From principal moments, the axes in columns, right-handed, and the state. No two moments are
    /// equal, and ω is not along a principal axis. None if it is along the intermediate one up to
    /// underflow: the other rates are no normal numbers beside it.
    pub fn new(moments: [f64; 3], principal: &Matrix3<f64>, state: &Rotation) -> Option<Self> {
        // all rates share one power of two
        let exponent = scale::exponent(state.angular_velocity.amax());
        let w = scale::scaled(&state.angular_velocity, -exponent);
        let Arranged {
            axes,
            moments: [i1, i2, i3],
            rates: w,
            roots,
            sign,
        } = arrange(of_order_one(moments), principal, &w);
        let [d12, d23, d13] = [i2 - i1, i3 - i2, i3 - i1].map(f64::abs);
        let root = math::sqrt;
        let [x, y] = [root(i1 * d13) * w.x, root(i2 * d23) * w.y];
        let h3 = math::hypot(x, y); // √E₃
        let [y1, z] = [root(i2 * d12) * w.y, root(i3 * d13) * w.z];
        let h1 = root(y1 * y1 + z * z); // √E₁
        let complement = f64::min(1.0, root(d13 / d23) / h1 * roots[0] * roots[1]);
        let ratio = root(d12 / d23) * h3 / (h1 * (1.0 + complement));
        let modulus = ratio * ratio; // k₁ = k²/(1 + k')²
        let rate = sign * root(d23 / (i1 * i2 * i3)) * h1 / (1.0 + modulus);
        let [r1, r2, r3] = [i1 * d13, i2 * d23, i3 * d13].map(root);
        let rates = Vector3::new(h3 / r1, h3 / r2, h1 / r3);
        let momenta = Vector3::new(i1, i2, i3).component_mul(&rates);
        // |m| where sn = 0
        let size = root(momenta.x * momenta.x + momenta.z * momenta.z);
        let whole = size + momenta.z;
        let energy = momenta.x * rates.x + momenta.z * rates.z;

        let first = Elliptic {
            sn: y / h3,
            cn: x / h3,
            dn: z / h1,
        };
        if first.dn + complement < f64::MIN_POSITIVE {
            return None;
        }
        let jacobi = Jacobi::new(2.0 * root(complement) / (1.0 + complement));
        let phase = Phase::new(jacobi, halved(first, complement), rate);
        let slant = momenta.x / whole;
        let parameter = modulus * slant * slant;
        let square = parameter * (1.0 + parameter) * (parameter + modulus * modulus);
        let third = ThirdKind::new(&jacobi, [parameter, 1.0 + parameter, root(square)]);
        let amplitude = 2.0 * modulus * momenta.z * h3 * h3 / (i3 * whole * whole * rate.abs());
        let precession = (energy + size * rates.z) / whole + amplitude * third.rate(&phase);
        let swing = attitude::to_third_axis(&(Vector3::new(i1, i2, i3).component_mul(&w) / size));
        let back = mapped(&axes, &swing.conjugate());
        let back = state.attitude.quaternion() * back;

        Some(Self {
            axes,
            start: attitude::normalized(&back),
            phase: phase.faster(exponent),
            complement,
            modulus,
            rates: scale::scaled(&rates, exponent),
            directions: momenta / size,
            precession: libm::scalbn(precession, exponent),
            amplitude,
            third,
        })
    }

    pub fn at(&self, time: f64) -> Rotation {
        let reading = self.phase.at(time);
        let Elliptic { sn, cn, dn } = doubled(reading.elliptic(), self.modulus, self.complement);
        let functions = Vector3::new(cn, sn, dn);
        let periodic = self.third.periodic(&self.phase, &reading);
        let turned =
            Twofold::product(self.precession, time) + Twofold::from(self.amplitude * periodic);
        let (sine, cosine) = turned.scaled(-1).sin_cos();
        let swing = attitude::to_third_axis(&self.directions.component_mul(&functions));
        let turn = Quaternion::new(cosine, 0.0, 0.0, sine) * swing;
        let attitude = self.start.quaternion() * mapped(&self.axes, &turn);
        Rotation {
            attitude: attitude::normalized(&attitude),
            angular_velocity: self.axes * self.rates.component_mul(&functions),
        }
    }

    /// Twice the period of dn; none on the separatrix.
    pub fn period(&self) -> Option<f64> {
        let jacobi = &self.phase.jacobi;
        (!jacobi.is_hyperbolic()).then(|| core::f64::consts::TAU / self.phase.rate.abs())
    }
}

/// From the modulus k to k₁: the inverse of [`doubled`].
fn halved(Elliptic { sn, cn, dn }: Elliptic, complement: f64) -> Elliptic {
    let (above, below) = (1.0 + complement, 1.0 + dn);
    Elliptic {
        sn: sn * above / below,
        cn: cn * math::sqrt(2.0 * above / (below * (dn + complement))),
        dn: math::sqrt(2.0 * (dn + complement) / (below * above)),
    }
}

/// Landen's transformation, from k₁ to k: `sn(u) = (1 + k₁) sn/(1 + k₁ sn²)`, with the functions of
/// `u/(1 + k₁)`.
fn doubled(Elliptic { sn, cn, dn }: Elliptic, modulus: f64, complement: f64) -> Elliptic {
    let square = sn * sn;
    let scale = 1.0 / (1.0 + modulus * square);
    let rest = 2.0 * complement / (1.0 + complement); // 1 - k₁
    Elliptic {
        sn: (1.0 + modulus) * sn * scale,
        cn: cn * dn * scale,
        dn: (cn * cn + rest * square) * scale,
    }
}

/// The same rotation in other axes.
fn mapped(axes: &Matrix3<f64>, rotation: &Quaternion<f64>) -> Quaternion<f64> {
    Quaternion::from_parts(rotation.w, axes * rotation.imag())
}
