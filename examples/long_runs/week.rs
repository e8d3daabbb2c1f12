//! A week of a satellite's attitude, on a circular orbit and without loads.

use nalgebra::Vector3;
use newton_euler::integrate::{
    self, DormandPrince, IntegrationError, Sample, TaylorSeries, Tolerant,
};
use newton_euler::prelude::*;

rigid_body!(Satellite {
    doc: "In the gravity gradient, to the second order of its size; the orbit is in the plane of world x and y.",
    motion: rotation,
    params: [orbit_rate = 1.0780e-3[rad / s]],
    inertia: principal(120, 150, 90)[kg * m ^ 2],
    locals: [
        up = world((orbit_rate * t).cos(), (orbit_rate * t).sin(), 0),
        n = up.in_body(),
        along = 120[kg * m ^ 2] * n.x.powi(2)
            + 150[kg * m ^ 2] * n.y.powi(2)
            + 90[kg * m ^ 2] * n.z.powi(2),
    ],
    potentials: [gravity = 1.5 * orbit_rate.powi(2) * along],
    outputs: [energy, momentum, taylor],
});

rigid_body!(Coasting {
    doc: "The same without loads.",
    motion: rotation,
    inertia: principal(120, 150, 90)[kg * m ^ 2],
    outputs: [energy, momentum, flow, taylor],
});

/// \[s\]
pub const WEEK: f64 = 604_800.0;
/// How often its energy is looked at.
const EVERY: f64 = 60.0;

/// Tumbling at a third of a degree a second, four times the rate of the orbit.
pub fn start() -> Rotation {
    Rotation {
        angular_velocity: Vector3::new(0.004, 0.001, -0.002),
        ..Rotation::default()
    }
}

impl Satellite {
    /// What a circular orbit leaves of the energy, after Jacobi: `H = T + U - Ω · L`, the energy in axes that turn with the orbit.
    pub fn jacobi(&self, time: f64, state: &Rotation) -> f64 {
        let energy = self.kinetic_energy(state) + self.potential_energy(time, state, &());
        energy - self.params().orbit_rate * self.angular_momentum(state).z
    }
}

/// The largest relative change of Jacobi's integral within a span of time \[s\].
///
/// # Errors
/// Where the integration ends.
pub fn change<M>(seconds: f64, tolerance: f64) -> Result<f64, IntegrationError<Rotation>>
where
    M: integrate::Method<Satellite> + Tolerant,
{
    let (satellite, start) = (Satellite::default(), start());
    let begin = satellite.jacobi(0.0, &start);
    let motion = satellite
        .integrate(&start)
        .method(M::with_tolerance(tolerance));
    let mut largest = 0.0_f64;
    for sample in motion.samples(seconds, EVERY) {
        let Sample { time, state } = sample?;
        largest = largest.max((satellite.jacobi(time, &state) / begin - 1.0).abs());
    }
    Ok(largest)
}

/// By how much series are off the closed form in attitude \[rad\], and how much their energy changes, without loads.
///
/// # Errors
/// Where the integration ends.
pub fn coasting(seconds: f64, tolerance: f64) -> Result<[f64; 2], IntegrationError<Rotation>> {
    let (body, start) = (Coasting::default(), start());
    let motion = body.integrate(&start).method(TaylorSeries { tolerance });
    let (end, exact) = (motion.to(seconds)?, body.flow(&start, seconds));
    let energy = body.kinetic_energy(&end) / body.kinetic_energy(&start) - 1.0;
    Ok([end.attitude.angle_to(&exact.attitude), energy.abs()])
}

/// The week, by some methods.
///
/// # Errors
/// Where the integration ends.
pub fn print() -> Result<(), IntegrationError<Rotation>> {
    println!("a satellite's week: largest relative change of Jacobi's integral, every minute");
    for tolerance in [1e-9, 1e-12, 1e-15] {
        let (series, pairs) = (
            change::<TaylorSeries>(WEEK, tolerance)?,
            change::<DormandPrince>(WEEK, tolerance)?,
        );
        println!("  tolerance {tolerance:e}: Taylor {series:.1e}, DOP853 {pairs:.1e}");
    }
    let [angle, energy] = coasting(WEEK, 1e-15)?;
    println!("without loads: energy {energy:.1e}, attitude {angle:.1e} rad off the closed form\n");
    Ok(())
}
