//! Attitude, rate and gyro bias of a satellite, from a gyro sampled ten times a second and a star
//! tracker once a second: an error-state Kalman filter (F. L. Markley, J. L. Crassidis,
//! "Fundamentals of Spacecraft Attitude Determination and Control", chapter 6), using the crate
//! `adskalman`.
//!
//! The estimate is a state of the satellite, and follows its equations of motion. Its error x = (e,
//! dw, db) is the tangent vector of `linearize`: attitude exp(e), rate + dw, bias + db. So the
//! filter's matrices follow from the description:
//!
//! ```text
//! x(t + h) = P x(t) + Q u        u: unknown torque and drift of the bias, held for a period
//! ```
//!
//! Torques disturb the true satellite, and the bias of its gyro drifts; both are inputs of the same
//! description.
//!
//! Asserts: over fifty runs, x.C^-1 x with the covariance C of the filter is distributed as
//! chi-square, and so are the innovations of both sensors; 99.7 % of the errors are within three
//! standard deviations; a filter that assumes half the noise of the star tracker fails.

use adskalman::{
    CovarianceUpdateMethod::JosephForm, ObservationModel, StateAndCovariance,
    TransitionModelLinearNoControl,
};
use newton_euler::nalgebra::{Const, SMatrix, SVector, UnitQuaternion, Vector3, Vector6, vector};
use newton_euler::prelude::*;

rigid_body!(Satellite {
    doc: "A satellite, and the bias of its gyro.",
    motion: rotation,
    inputs: [
        torque = body(_, _, _)[N * m],
        drift = body(_, _, _)[rad / s ^ 2]
    ],
    states: [bias_x[rad / s], bias_y[rad / s], bias_z[rad / s]],
    rates: [
        bias_x = drift.in_body().x,
        bias_y = drift.in_body().y,
        bias_z = drift.in_body().z,
    ],
    mass: 60[kg],
    inertia: principal(2.1, 3.4, 4.2)[kg * m ^ 2],
    moments: [wheels = torque],
    outputs: [linearization],
});

type Errors = SVector<f64, 9>;
type Covariance = SMatrix<f64, 9, 9>;

const PERIOD: f64 = 0.1;
/// The number of periods between readings of the star tracker.
const SELDOM: u32 = 10;
const PERIODS: u32 = 1200;
const RUNS: u32 = 50;

// standard deviations
const TORQUE: f64 = 2e-3;
const DRIFT: f64 = 1e-5;
const GYRO: f64 = 1e-4;
/// Across the line of sight, which is body z, and about it.
const STARS: [f64; 3] = [24e-6, 24e-6, 240e-6];
/// At the start, for attitude, rate and bias.
const START: [f64; 3] = [1e-3, 1e-3, 1e-3];

/// Normal random numbers, the same in every run of the program (G. Steele, D. Lea, C. Flood, "Fast
/// splittable pseudorandom number generators", 2014; G. Box, M. Muller, 1958).
struct Noise(u64);

impl Noise {
    /// Between zero and one.
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let high = u32::try_from((mixed ^ (mixed >> 31)) >> 32).expect("32 bits");
        (f64::from(high) + 0.5) / 4_294_967_296.0
    }

    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * self.uniform().ln()).sqrt();
        radius * (std::f64::consts::TAU * self.uniform()).cos()
    }

    fn vector(&mut self, deviations: [f64; 3]) -> Vector3<f64> {
        Vector3::from(deviations.map(|deviation| deviation * self.normal()))
    }
}

/// The step of the errors over a period.
struct Transition {
    step: Covariance,
    transposed: Covariance,
    noise: Covariance,
}

impl Transition {
    /// About an estimate.
    fn about(satellite: &Satellite, state: &SatelliteState, input: &SatelliteInput) -> Self {
        let (step, push) = satellite.linearize(0.0, state, input).discretized(PERIOD);
        let deviations = Vector6::from([TORQUE, TORQUE, TORQUE, DRIFT, DRIFT, DRIFT]);
        let push = push * SMatrix::from_diagonal(&deviations);
        Self {
            step,
            transposed: step.transpose(),
            noise: push * push.transpose(),
        }
    }
}

impl TransitionModelLinearNoControl<f64, Const<9>> for Transition {
    fn F(&self) -> &Covariance {
        &self.step
    }

    fn FT(&self) -> &Covariance {
        &self.transposed
    }

    fn Q(&self) -> &Covariance {
        &self.noise
    }
}

/// The matrix of a sensor for the errors, and its noise.
struct Sensor {
    sees: SMatrix<f64, 3, 9>,
    transposed: SMatrix<f64, 9, 3>,
    noise: SMatrix<f64, 3, 3>,
}

impl Sensor {
    /// A sum of attitude, rate and bias with these weights.
    fn new(times: [f64; 3], deviations: [f64; 3]) -> Self {
        let mut sees = SMatrix::zeros();
        for row in 0..3 {
            for (part, times) in times.into_iter().enumerate() {
                sees[(row, 3 * part + row)] = times;
            }
        }
        let deviations = Vector3::from(deviations);
        Self {
            sees,
            transposed: sees.transpose(),
            noise: SMatrix::from_diagonal(&deviations.component_mul(&deviations)),
        }
    }
}

impl ObservationModel<f64, Const<9>, Const<3>> for Sensor {
    fn H(&self) -> &SMatrix<f64, 3, 9> {
        &self.sees
    }

    fn HT(&self) -> &SMatrix<f64, 9, 3> {
        &self.transposed
    }

    fn R(&self) -> &SMatrix<f64, 3, 3> {
        &self.noise
    }
}

fn bias(state: &SatelliteState) -> Vector3<f64> {
    vector![state.bias_x, state.bias_y, state.bias_z]
}

/// A state with an error added to it.
fn corrected(state: &SatelliteState, error: &Errors) -> SatelliteState {
    let parts = [0, 3, 6].map(|row| error.fixed_rows::<3>(row).into_owned());
    let [bias_x, bias_y, bias_z] = (bias(state) + parts[2]).into();
    SatelliteState {
        motion: Rotation {
            attitude: state.motion.attitude * UnitQuaternion::from_scaled_axis(parts[0]),
            angular_velocity: state.motion.angular_velocity + parts[1],
        },
        bias_x,
        bias_y,
        bias_z,
    }
}

/// The correction of the estimate that gives the truth.
fn error(truth: &SatelliteState, estimate: &SatelliteState) -> Errors {
    let turn = estimate.motion.attitude.inverse() * truth.motion.attitude;
    let rate = truth.motion.angular_velocity - estimate.motion.angular_velocity;
    let parts = [turn.scaled_axis(), rate, bias(truth) - bias(estimate)];
    Errors::from_fn(|row, _| parts[row / 3][row % 3])
}

/// An estimate and its covariance.
struct Filter {
    satellite: Satellite,
    state: SatelliteState,
    covariance: Covariance,
}

impl Filter {
    /// Predicts over a period, by the equations of motion and with the commanded torque.
    fn predict(&mut self, input: SatelliteInput) {
        let transition = Transition::about(&self.satellite, &self.state, &input);
        let none = StateAndCovariance::new(Errors::zeros(), self.covariance);
        self.covariance = *transition.predict(&none).covariance();
        self.state = moved(&self.satellite, &self.state, input);
    }

    /// Updates by a sensor's reading minus the estimate's; returns its square in standard
    /// deviations.
    fn update(&mut self, sensor: &Sensor, innovation: &Vector3<f64>) -> f64 {
        let spread = sensor.sees * self.covariance * sensor.transposed + sensor.noise;
        let spread = spread.cholesky().expect("noise is positive");
        let prior = StateAndCovariance::new(Errors::zeros(), self.covariance);
        let posterior = sensor
            .update(&prior, innovation, JosephForm)
            .expect("a covariance");
        self.state = corrected(&self.state, posterior.state());
        self.covariance = *posterior.covariance();
        innovation.dot(&spread.solve(innovation))
    }

    /// The square of an error in its standard deviations.
    fn square(&self, error: &Errors) -> f64 {
        let factor = self.covariance.cholesky().expect("a covariance");
        error.dot(&factor.solve(error))
    }
}

/// One period later.
fn moved(satellite: &Satellite, state: &SatelliteState, input: SatelliteInput) -> SatelliteState {
    let motion = satellite.integrate(state).input(input);
    motion.to(PERIOD).expect("it turns")
}

/// The command to the wheels.
fn command(period: u32) -> Vector3<f64> {
    let time = PERIOD * f64::from(period);
    vector![
        (0.11 * time).sin(),
        (0.07 * time).cos(),
        (0.05 * time).sin()
    ] * 0.02
}

/// Sums over runs.
#[derive(Default)]
struct Tally {
    /// Of x.C^-1 x, at four times.
    errors: [f64; 4],
    /// Of innovations: gyro and star tracker.
    innovations: [f64; 2],
    /// Errors within three standard deviations.
    within: u32,
    /// Squares of the errors at the end.
    squares: Errors,
}

impl Tally {
    /// One run, with a filter that assumes this noise of its star tracker.
    fn run(&mut self, seed: u64, stars: [f64; 3]) {
        let (satellite, mut noise) = (Satellite::default(), Noise(seed));
        let (gyro, tracker) = (
            Sensor::new([0.0, 1.0, 1.0], [GYRO; 3]),
            Sensor::new([1.0, 0.0, 0.0], stars),
        );
        let mut truth = SatelliteState {
            motion: Rotation {
                angular_velocity: vector![0.05, 0.08, -0.03],
                ..Rotation::default()
            },
            ..SatelliteState::default()
        };
        let start = Errors::from_fn(|row, _| START[row / 3]);
        let first = start.map(|deviation| deviation * noise.normal());
        let mut filter = Filter {
            satellite: satellite.clone(),
            state: corrected(&truth, &first),
            covariance: SMatrix::from_diagonal(&start.component_mul(&start)),
        };
        for period in 1..=PERIODS {
            let torque = command(period);
            truth = moved(
                &satellite,
                &truth,
                SatelliteInput {
                    torque: torque + noise.vector([TORQUE; 3]),
                    drift: noise.vector([DRIFT; 3]),
                },
            );
            let drift = Vector3::zeros();
            filter.predict(SatelliteInput { torque, drift });

            let shown = truth.motion.angular_velocity + bias(&truth) + noise.vector([GYRO; 3]);
            let expected = filter.state.motion.angular_velocity + bias(&filter.state);
            self.innovations[0] += filter.update(&gyro, &(shown - expected));
            if period.is_multiple_of(SELDOM) {
                let off = UnitQuaternion::from_scaled_axis(noise.vector(STARS));
                let shown = truth.motion.attitude * off;
                let turn = filter.state.motion.attitude.inverse() * shown;
                self.innovations[1] += filter.update(&tracker, &turn.scaled_axis());
            }
            self.look(period, &filter, &error(&truth, &filter.state));
        }
    }

    fn look(&mut self, period: u32, filter: &Filter, error: &Errors) {
        let deviations = filter.covariance.diagonal().map(f64::sqrt);
        let pairs = error.iter().zip(&deviations);
        let within = pairs.filter(|(error, deviation)| error.abs() < 3.0 * **deviation);
        self.within += u32::try_from(within.count()).expect("nine at most");
        if period.is_multiple_of(PERIODS / 4) {
            let quarter = 4 * (period - 1) / PERIODS;
            self.errors[quarter as usize] += filter.square(error);
        }
        if period == PERIODS {
            self.squares += error.component_mul(error);
        }
    }
}

/// The bounds of chi-square in 999 of 1000 cases (E. Wilson, M. Hilferty, 1931).
fn bounds(freedoms: u32) -> [f64; 2] {
    let share = 2.0 / (9.0 * f64::from(freedoms));
    [-3.29, 3.29].map(|deviations| (1.0 - share + deviations * share.sqrt()).powi(3))
}

/// Whether a sum of squares is within the bounds of chi-square; prints it divided by the degrees of
/// freedom.
fn is_consistent(name: &str, sum: f64, freedoms: u32) -> bool {
    let ([least, most], mean) = (bounds(freedoms), sum / f64::from(freedoms));
    println!("{name:<38} {mean:.4}   {least:.4} to {most:.4}");
    (least..most).contains(&mean)
}

fn main() {
    let mut tally = Tally::default();
    for run in 0..RUNS {
        tally.run(u64::from(run), STARS);
    }
    println!("squares in standard deviations, by the freedom; 99.9 % of chi-square");
    for (quarter, sum) in (1..).zip(tally.errors) {
        let name = format!("errors after {} s", 30 * quarter);
        assert!(is_consistent(&name, sum, 9 * RUNS));
    }
    let [gyro, stars] = tally.innovations;
    assert!(is_consistent(
        "innovations of the gyro",
        gyro,
        3 * PERIODS * RUNS
    ));
    let answers = 3 * PERIODS / SELDOM * RUNS;
    assert!(is_consistent(
        "innovations of the star tracker",
        stars,
        answers
    ));

    let within = f64::from(tally.within) / f64::from(9 * PERIODS * RUNS);
    println!("within three standard deviations {:.2} %", 100.0 * within);
    assert!((within - 0.9973).abs() < 0.001);

    let off = tally.squares.map(|sum| (sum / f64::from(RUNS)).sqrt());
    println!("rms errors at the end: attitude µrad, rate and bias µrad/s");
    for part in 0..3 {
        let [x, y, z] = [0, 1, 2].map(|row| 1e6 * off[3 * part + row]);
        println!("  {x:8.1} {y:8.1} {z:8.1}");
    }
    // better than a single reading of the star tracker
    assert!((0..3).all(|row| off[row] < STARS[row]));

    // assuming a star tracker twice as good is detected
    let mut wrong = Tally::default();
    for run in 0..RUNS / 10 {
        wrong.run(u64::from(run), STARS.map(|deviation| 0.5 * deviation));
    }
    let [_, stars] = wrong.innovations;
    assert!(!is_consistent(
        "told of half the noise",
        stars,
        answers / 10
    ));
}
