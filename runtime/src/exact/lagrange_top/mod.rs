//! Lagrange's top.

use nalgebra::{Complex, Quaternion, UnitVector3, Vector3};

use super::FreeRotation;
use crate::bodies::path::Path;
use crate::exact::elliptic::jacobi::{Elliptic, Jacobi};
use crate::exact::elliptic::phase::Phase;
use crate::mechanics::attitude;
use crate::numbers::math;
use crate::numbers::scale;
use crate::numbers::twofold::Twofold;
use crate::state::Rotation;

mod parameter;
mod turn;
mod turning_points;

use parameter::{Ingredients, Parameter};
use turn::Turn;
use turning_points::{Start, TurningPoints};

/// A body that is symmetric about an axis, under a couple `k × e`: k is constant in the world, e is
/// the unit vector along the axis.
///
/// Examples are a top about a fixed point of its axis, with k upwards, of size m g l, and e from
/// there to the center of mass; or a magnet in a uniform field.
///
/// The height of the axis over the horizon is an elliptic function of time, and the attitude
/// follows from integrals of the third kind, in the parameters of Cayley and Klein. There are no
/// angles, so a top that is upright or hanging, or passes these positions, is no special case. F.
/// Klein, A. Sommerfeld, Über die Theorie des Kreisels (1897), chapter VI; E. T. Whittaker,
/// Analytical Dynamics, §§ 71 to 74.
///
/// Errors are one rounding per radian turned, even if the top nearly precesses steadily, sleeps, or
/// falls along the separatrix. The sign of the quaternion is continuous in time. A top at rest
/// falls in the direction of its tilt, however small, down to 1e-70; below that it stays at rest.
///
/// ```
/// use newton_euler::exact::{LagrangeTop, Path};
/// use newton_euler::prelude::*;
/// use newton_euler::nalgebra::Vector3;
///
/// // released with its axis level: it falls, and rises again to its initial height
/// let start = Rotation {
///     attitude: newton_euler::attitude::exp(&(Vector3::x() * core::f64::consts::FRAC_PI_2)),
///     angular_velocity: Vector3::new(0.0, 0.0, 100.0),
/// };
/// let top = LagrangeTop::new([0.0021, 0.0009], Vector3::z_axis(), Vector3::z() * 0.24, &start);
/// let nodding = top.period().unwrap();
/// let height = |time| (top.at(time).attitude * Vector3::z()).z;
/// assert!(height(nodding / 2.0) < -0.1 && height(nodding).abs() < 1e-13);
/// assert_eq!(top.at(1.0).angular_velocity.z, 100.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LagrangeTop(Case);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Case {
    Free(FreeRotation),
    Nutating(Nutation),
}

impl LagrangeTop {
    /// From the moments perpendicular to the axis and about it \[kg m²\], about the held point or
    /// G; the axis, in the body; k \[N m\], in the world; and the state at time zero.
    #[must_use]
    pub fn new(
        moments: [f64; 2],
        axis: UnitVector3<f64>,
        couple: Vector3<f64>,
        state: &Rotation,
    ) -> Self {
        if couple == Vector3::zeros() {
            return Self(Case::Free(FreeRotation::symmetric(moments, axis, state)));
        }
        Self(
            match Nutation::new(moments, axis.into_inner(), &couple, state) {
                Some(nutation) => Case::Nutating(nutation),
                None => Case::Free(FreeRotation::steady(state)),
            },
        )
    }

    /// The time in which the axis falls and rises once \[s\]. `None` in three cases: the height is
    /// constant because there is no couple; the top is at rest upright or hanging; or it moves on
    /// the separatrix, where it never falls back.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        match &self.0 {
            Case::Free(_) => None,
            Case::Nutating(nutation) => nutation.period(),
        }
    }
}

impl Path for LagrangeTop {
    type State = Rotation;

    fn at(&self, time: f64) -> Rotation {
        match &self.0 {
            Case::Free(free) => free.at(time),
            Case::Nutating(nutation) => nutation.at(time),
        }
    }

    fn pace(&self, time: f64) -> f64 {
        match &self.0 {
            Case::Free(free) => free.pace(time),
            Case::Nutating(nutation) => {
                let turning = self.at(0.0).angular_velocity.norm();
                // falling from upright, it rotates at twice the rate of the phase
                1.0 / (turning + 2.0 * nutation.phase.rate.abs())
            }
        }
    }
}

/// For tilts below this, an attitude gives the tilt to fewer digits than the attitude itself has.
const NEAR: f64 = 0.1;

/// Tilts, and velocities in their unit, whose fourth powers do not underflow.
const LEAST: f64 = 1e-70;

/// The oscillation of the tilt of a top.
struct Nodding {
    start: Start,
    points: TurningPoints,
    /// `u₂ - u₁`
    apart: f64,
    /// `2a (u₃ - u₁)`
    span: f64,
    /// 2a
    twice: f64,
    /// 2 λ
    double_rate: f64,
    /// sn, cn and dn at time zero.
    first: Elliptic,
    phase: Phase,
}

impl Nodding {
    fn new(start: Start) -> Self {
        let points = TurningPoints::new(&start);
        let [low, high, third] = points.from_start;
        let twice = 2.0 * start.couple.value();
        let (apart, span) = (low + high, third + twice * low);
        let double_rate = math::sqrt(span);
        let share = |part: f64, whole: f64, rest: f64| {
            if whole > 0.0 {
                math::sqrt(part / whole)
            } else {
                rest
            }
        };
        let first = Elliptic {
            sn: f64::copysign(share(low, apart, 0.0), start.rise.value()),
            cn: share(high, apart, 1.0),
            dn: share(third, span, 1.0),
        };
        let jacobi = Jacobi::new(f64::min(1.0, share(points.gap, span, 1.0)));
        Self {
            start,
            points,
            apart,
            span,
            twice,
            double_rate,
            first,
            phase: Phase::new(jacobi, first, 0.5 * double_rate),
        }
    }

    /// α for the sign 1, β for -1, from its ω, its value and its velocity at time zero.
    fn parameter(
        &self,
        sign: f64,
        (rate, value, velocity): (f64, Complex<f64>, Complex<f64>),
    ) -> Parameter {
        let (pole, distances) = if sign > 0.0 {
            (self.start.nadir, self.points.from_nadir)
        } else {
            (self.start.zenith, self.points.from_zenith)
        };
        let about = self.start.vertical + self.start.spin * pole * Twofold::from(sign);
        let given = Ingredients {
            sign,
            distances,
            apart: self.apart,
            span: self.span,
            twice: self.twice,
            about: about.value(),
            rate,
            first: self.first,
            start: [value, velocity / self.double_rate],
        };
        Parameter::new(&given, &self.phase)
    }
}

/// The motion of a top that is not at rest on the vertical.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Nutation {
    /// Takes axes whose third is along k to those of the world.
    world: Quaternion<f64>,
    /// Takes axes of the body to those whose third is e.
    body: Quaternion<f64>,
    phase: Phase,
    /// α and β
    parameters: [Parameter; 2],
    /// 2 λ
    double_rate: f64,
    /// p
    spin: f64,
    /// Angular velocity along the axis.
    along: Vector3<f64>,
}

impl Nutation {
    /// `None` if the axis is vertical and at rest.
    fn new(
        [across, along]: [f64; 2],
        axis: Vector3<f64>,
        couple: &Vector3<f64>,
        state: &Rotation,
    ) -> Option<Self> {
        let (size, up) = scale::direction(couple);
        let [world, body] = [onto_third(&up).conjugate(), onto_third(&axis)];
        let mut attitude = world.conjugate() * state.attitude.quaternion() * body.conjugate();
        if is_next_to_vertical(&attitude) {
            let [world, body] = [couple, &axis].map(Turn::to_third_axis);
            attitude = (world * Turn::from(state.attitude.quaternion()) * body.conjugate()).value();
        }
        let alpha = Complex::new(attitude.w, attitude.k);
        let beta = Complex::new(attitude.i, attitude.j);

        // all rates share one power of two
        let rates = state.angular_velocity;
        let couple = size / Twofold::from(across);
        let exponent = scale::exponent(f64::max(rates.amax(), math::sqrt(couple.value())));
        let couple = couple.scaled(-2 * exponent);
        let rates = scale::scaled(&rates, -exponent);
        let axial = axis.dot(&rates);
        let turned = rotated(&body, &(rates - axis * axial));
        let omega = Complex::new(turned.x, turned.y);
        let is_least = |part: Complex<f64>| f64::max(part.re.abs(), part.im.abs()) < LEAST;
        if is_least(omega) && (is_least(alpha) || is_least(beta)) {
            return None;
        }

        let spin = Twofold::from(along) / Twofold::from(across) * Twofold::from(axial);
        let start = start(couple, spin, [alpha, beta], omega);
        let nodding = Nodding::new(start);
        let excess = Twofold::sum(across, -along) / Twofold::from(across);
        let rate = 0.5 * (excess * Twofold::from(axial)).value();
        let spin = spin.value();
        let turning = Complex::new(0.0, spin);
        let parameters = [
            (1.0, (rate, alpha, turning * alpha - beta * omega.conj())),
            (-1.0, (-rate, beta, alpha * omega - turning * beta)),
        ];
        let parameters =
            parameters.map(|(sign, given)| nodding.parameter(sign, given).faster(exponent));
        Some(Self {
            world,
            body,
            phase: nodding.phase.faster(exponent),
            parameters,
            double_rate: libm::scalbn(nodding.double_rate, exponent),
            spin: libm::scalbn(spin, exponent),
            along: axis * axis.dot(&state.angular_velocity),
        })
    }

    fn at(&self, time: f64) -> Rotation {
        let reading = self.phase.at(time);
        let [[alpha, falling], [beta, rising]] = self
            .parameters
            .map(|parameter| parameter.at(time, &self.phase, &reading));
        let turning = Complex::new(0.0, self.spin);
        // α' and β' without the spin, computed from the derivative of the smaller parameter
        let [upright, hanging] = [alpha, beta].map(|parameter| parameter.norm_sqr());
        let omega = if upright >= hanging {
            alpha.conj() * (turning * beta + rising * self.double_rate) / upright
        } else {
            beta * (turning * alpha - falling * self.double_rate).conj() / hanging
        };
        let attitude = Quaternion::new(alpha.re, beta.re, beta.im, alpha.im);
        let across = Vector3::new(omega.re, omega.im, 0.0);
        Rotation {
            attitude: attitude::normalized(&(self.world * attitude * self.body)),
            angular_velocity: self.along + rotated(&self.body.conjugate(), &across),
        }
    }

    fn period(&self) -> Option<f64> {
        (!self.phase.jacobi.is_hyperbolic()).then(|| core::f64::consts::PI / self.phase.rate)
    }
}

/// The constants of the height of the axis, from a, p, α and β, and the angular velocity across the
/// axis.
fn start(
    couple: Twofold,
    spin: Twofold,
    [alpha, beta]: [Complex<f64>; 2],
    omega: Complex<f64>,
) -> Start {
    let square = |part: Complex<f64>| {
        Twofold::product(part.re, part.re) + Twofold::product(part.im, part.im)
    };
    let (upright, hanging) = (square(alpha), square(beta));
    // Γ = 2 i α* β, for a quaternion that is a unit to rounding
    let half = upright + hanging;
    let double = |part: Twofold| part.scaled(1) / half;
    let [gamma_x, gamma_y] = [
        double(Twofold::product(alpha.im, beta.re) - Twofold::product(alpha.re, beta.im)),
        double(Twofold::product(alpha.re, beta.re) + Twofold::product(alpha.im, beta.im)),
    ];
    let [x, y] = [omega.re, omega.im].map(Twofold::from);
    Start {
        couple,
        spin,
        nadir: double(upright),
        zenith: double(hanging),
        vertical: gamma_x * x + gamma_y * y,
        rise: gamma_x * y - gamma_y * x,
        square: square(omega),
    }
}

/// A rotation of a unit vector to the third axis.
fn onto_third(unit: &Vector3<f64>) -> Quaternion<f64> {
    if unit.z >= 0.0 {
        return attitude::to_third_axis(unit);
    }
    // first half a turn about the first axis
    let turned = Vector3::new(unit.x, -unit.y, -unit.z);
    attitude::to_third_axis(&turned) * Quaternion::new(0.0, 1.0, 0.0, 0.0)
}

/// Whether an attitude determines the tilt of the third axis to few digits only.
fn is_next_to_vertical(attitude: &Quaternion<f64>) -> bool {
    let is_near = |a: f64, b: f64| f64::max(a.abs(), b.abs()) < NEAR;
    is_near(attitude.w, attitude.k) || is_near(attitude.i, attitude.j)
}

/// A vector, turned by a unit quaternion.
fn rotated(rotation: &Quaternion<f64>, vector: &Vector3<f64>) -> Vector3<f64> {
    let (w, v) = (rotation.w, rotation.imag());
    let twice = 2.0 * v.cross(vector);
    vector + twice * w + v.cross(&twice)
}
