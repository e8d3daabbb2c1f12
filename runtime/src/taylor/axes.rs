//! The axes of series.

use nalgebra::{Vector3, Vector4};

use crate::numbers::count::real;
use crate::numbers::math;
use crate::state::Coordinates;

/// The axes of a body, or axes that do not spin with it.
///
/// Let a body be symmetric about e: its accelerations do not change if its axes are rotated about e
/// ([`Dependence::body`](crate::structure::Dependence::body)), and its spin s = ω·e is constant. In
/// axes F that rotate relative to it at -σ about e, with the components of the whole angular
/// velocity in them, the motion is slower:
///
/// ```text
/// q_F' = q_F (0, ω_F - σ e) / 2        ω_F' = α(q_F, ω_F) + σ e × ω_F
/// ```
///
/// α is the same function as in body axes. Since s is a number, products with it are no
/// products of series. With F along the body axes at t₀,
///
/// ```text
/// q = q_F exp(e σ (t - t₀) / 2)        ω = R_e(-σ (t - t₀)) ω_F
/// ```
///
/// while position and velocity are the same. In axes without spin, σ = s, the angular velocity of a
/// free body rotates at `β = s J_e / J_t`, with the moments of inertia along e and across it. For σ
/// = s - β it is constant, but the attitude rotates faster. [`rigid_body!`](crate::rigid_body) uses
/// σ = s - β / 2, halfway. Steps are then the longest or nearly so, for heavy tops flat and
/// slender, fast and slow; without spin those of flat tops would be shorter than in body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    begin: f64,
    direction: [f64; 3],
    spin: f64,
}

impl Axes {
    /// The axes of the body.
    pub const BODY: Self = Self::despun(0.0, [0.0; 3], 0.0);

    /// Axes along the body's at the time `begin` \[s\], relative to which it rotates at σ =
    /// `spin` \[rad/s\] about `direction`, a unit vector in both.
    #[must_use]
    pub const fn despun(begin: f64, direction: [f64; 3], spin: f64) -> Self {
        Self {
            begin,
            direction,
            spin,
        }
    }

    /// The state with these coordinates in these axes at a time \[s\].
    #[inline]
    pub(crate) fn state<S: Coordinates<Scalar = f64>>(
        &self,
        coordinates: &S::Array,
        time: f64,
    ) -> S {
        let Some(places) = self.turning::<S>() else {
            return S::from_coordinates(coordinates);
        };
        let e = Vector3::from(self.direction);
        let (sine, cosine) = math::sin_cos(0.5 * (self.spin * (time - self.begin)));
        let (q, w) = read::<S>(coordinates, places);
        let across = e.cross(&w);
        // sin θ = 2 s c, 1 - cos θ = 2 s², of half the angle
        let turned = w + (e.cross(&across) * sine - across * cosine) * (2.0 * sine);
        let mut coordinates = *coordinates;
        write::<S>(
            &mut coordinates,
            places,
            &(q * cosine + times(&q, &e) * sine),
            &turned,
        );
        S::from_coordinates(&coordinates)
    }

    /// Transforms the series of a motion that begins along the body axes into these axes:
    ///
    /// ```text
    /// c[n] = Σ_j  Gʲ c_F[n - j] / j!        G: q -> q (0, σ e) / 2, ω -> -σ e × ω, all else to 0
    /// ```
    pub(crate) fn turn<S: Coordinates<Scalar = f64>, const N: usize>(
        &self,
        coefficients: &mut [S::Array; N],
    ) {
        let Some(places) = self.turning::<S>() else {
            return;
        };
        let turning = Vector3::from(self.direction) * self.spin;
        let mut terms = *coefficients;
        for j in 1..N {
            for n in (j..N).rev() {
                let (q, w) = read::<S>(&terms[n - 1], places);
                let (q, w) = (
                    times(&q, &turning) * (0.5 / real(j)),
                    w.cross(&turning) / real(j),
                );
                write::<S>(&mut terms[n], places, &q, &w);
                let (sum_q, sum_w) = read::<S>(&coefficients[n], places);
                write::<S>(&mut coefficients[n], places, &(sum_q + q), &(sum_w + w));
            }
        }
    }

    /// Transforms the rate of the angular velocity into these axes, from that of the same
    /// coordinates in body axes: `+ σ e × ω_F`.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(crate) fn turn_rates<S: Coordinates<Scalar = f64>>(
        &self,
        coordinates: &S::Array,
        rates: &mut S::Array,
    ) {
        let Some([_, rate]) = self.turning::<S>() else {
            return;
        };
        let w = Vector3::from_fn(|k, _| coordinates.as_ref()[rate + k]);
        let turning = Vector3::from(self.direction).cross(&w) * self.spin;
        for (rate, turning) in rates.as_mut()[rate..rate + 3].iter_mut().zip(&turning) {
            *rate += turning;
        }
    }

    /// The places of attitude and angular velocity, if they differ in these axes from those in body
    /// axes.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn turning<S: Coordinates>(&self) -> Option<[usize; 2]> {
        S::AXES.filter(|_| self.spin != 0.0)
    }
}

/// The attitude, scalar last, and the angular velocity.
#[cfg_attr(not(unoptimized), inline(always))]
fn read<S: Coordinates<Scalar = f64>>(
    coordinates: &S::Array,
    [attitude, rate]: [usize; 2],
) -> (Vector4<f64>, Vector3<f64>) {
    let list = coordinates.as_ref();
    (
        Vector4::from_fn(|k, _| list[attitude + k]),
        Vector3::from_fn(|k, _| list[rate + k]),
    )
}

#[cfg_attr(not(unoptimized), inline(always))]
fn write<S: Coordinates<Scalar = f64>>(
    coordinates: &mut S::Array,
    [attitude, rate]: [usize; 2],
    q: &Vector4<f64>,
    w: &Vector3<f64>,
) {
    let list = coordinates.as_mut();
    list[attitude..attitude + 4].copy_from_slice(q.as_slice());
    list[rate..rate + 3].copy_from_slice(w.as_slice());
}

/// `q (0, v)`
#[cfg_attr(not(unoptimized), inline(always))]
fn times(q: &Vector4<f64>, v: &Vector3<f64>) -> Vector4<f64> {
    let (vector, scalar) = (q.xyz(), q.w);
    (v * scalar + vector.cross(v)).push(-vector.dot(v))
}
