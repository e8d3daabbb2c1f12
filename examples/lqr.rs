//! A quadrotor held in place by a linear-quadratic regulator: the gains follow from the
//! description.
//!
//! `linearize` gives x' = A x + B u about hover. `discretized` gives the step of a controller that
//! runs 200 times a second, x(t + h) = P x(t) + Q u. The gains K of u = -K x minimize the sum of
//! x.W x + u.R u. They follow from the solution S of Riccati's equation, found by doubling: each
//! round doubles the number of steps of the horizon (E. Chu, H. Fan, W. Lin, C. Wang,
//! "Structure-preserving algorithms for periodic discrete-time algebraic Riccati equations", 2004).
//!
//! Asserts: the residual of the equation; from a small tilt, the sum along the motion of the full
//! body agrees with the prediction of S; a tilt of 60 degrees settles.

use newton_euler::nalgebra::{SMatrix, SVector, UnitQuaternion, Vector3};
use newton_euler::prelude::*;

rigid_body!(Quadrotor {
    doc: "A quadrotor in a plus configuration; rotors 1 and 3 spin about -z.",
    motion: spatial,
    params: [arm = 0.17[m], drag_ratio = 0.016[m]],
    inputs: [thrust_1[N], thrust_2[N], thrust_3[N], thrust_4[N]],
    mass: 1.2[kg],
    inertia: principal(0.0123, 0.0123, 0.0224)[kg * m ^ 2],
    points: [
        front = (arm, 0, 0),
        left = (0, arm, 0),
        back = (-arm, 0, 0),
        right = (0, -arm, 0)
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        lift_1 = body(0, 0, thrust_1).at(front),
        lift_2 = body(0, 0, thrust_2).at(left),
        lift_3 = body(0, 0, thrust_3).at(back),
        lift_4 = body(0, 0, thrust_4).at(right),
    ],
    moments: [drag = body(
        0,
        0,
        drag_ratio * (thrust_1 - thrust_2 + thrust_3 - thrust_4)
    )],
    outputs: [linearization],
});

type States = SMatrix<f64, 12, 12>;
type Inputs = SMatrix<f64, 12, 4>;

const PERIOD: f64 = 0.005;

/// W, per second: of position, tilt, velocity and rate.
fn weights() -> States {
    let each = [4.0, 4.0, 4.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.1, 0.1, 0.1];
    States::from_diagonal(&SVector::from(each)) * PERIOD
}

/// R, the same for each thrust.
const EFFORT: f64 = 0.5 * PERIOD;

/// S of S = W + P^T S (1 + Q R^-1 Q^T S)^-1 P, and the gains.
fn regulator(p: &States, q: &Inputs) -> (States, SMatrix<f64, 4, 12>) {
    let (mut a, mut g, mut s) = (*p, q * q.transpose() / EFFORT, weights());
    for _doubling in 0..20 {
        let inverse = (States::identity() + g * s).try_inverse();
        let inverse = inverse.expect("g and s are not negative");
        let next = inverse * a;
        s += a.transpose() * s * next;
        g += a * inverse * g * a.transpose();
        a *= next;
    }
    let inner = SMatrix::<f64, 4, 4>::identity() * EFFORT + q.transpose() * s * q;
    let inner = inner.cholesky().expect("effort is positive");
    (s, inner.solve(&(q.transpose() * s * p)))
}

/// The deviation of a state from hover, in the coordinates of `linearize`.
fn off(state: &Spatial) -> SVector<f64, 12> {
    let tilt = state.attitude.scaled_axis();
    let parts = [state.position, tilt, state.velocity, state.angular_velocity];
    SVector::from_fn(|row, _| parts[row / 3][row % 3])
}

/// Thrusts relative to hover.
fn thrusts(more: SVector<f64, 4>) -> QuadrotorInput {
    let [thrust_1, thrust_2, thrust_3, thrust_4] = more.add_scalar(1.2 * 9.80665 / 4.0).into();
    QuadrotorInput {
        thrust_1,
        thrust_2,
        thrust_3,
        thrust_4,
    }
}

/// From a tilt about an axis between the arms: the accumulated sum, and the states every 0.25 s.
fn recover(quadrotor: &Quadrotor, gains: &SMatrix<f64, 4, 12>, tilt: f64) -> (Vec<Spatial>, f64) {
    let axis = Vector3::new(1.0, 0.5, 0.0).normalize();
    let attitude = UnitQuaternion::from_scaled_axis(axis * tilt);
    let start = Spatial {
        attitude,
        ..Spatial::default()
    };
    let mut sum = 0.0;
    let controller = |_time: f64, state: &Spatial| {
        let x = off(state);
        let u = -gains * x;
        sum += x.dot(&(weights() * x)) + EFFORT * u.norm_squared();
        thrusts(u)
    };
    let motion = quadrotor.integrate(&start).control(PERIOD, controller);
    let samples = motion.samples(5.0, 0.25);
    let states = samples.map(|sample| sample.expect("it flies").state);
    (states.collect(), sum)
}

/// The time after which the states stay within 5 cm and 1° of hover.
fn settling(states: &[Spatial]) -> f64 {
    println!("from 60°:  t/s   tilt/°   off/m");
    let mut settled = 0.0;
    for (quarter, state) in (0_u32..).zip(states) {
        let (time, off) = (0.25 * f64::from(quarter), state.position.norm());
        let tilt = state.attitude.angle().to_degrees();
        if quarter % 2 == 0 {
            println!("          {time:4.1}  {tilt:7.3}  {off:6.3}");
        }
        if off > 0.05 || tilt > 1.0 {
            settled = time + 0.25;
        }
    }
    settled
}

/// The gains, and their effect.
fn main() {
    let quadrotor = Quadrotor::default();
    let hover = thrusts(SVector::zeros());
    let (p, q) = quadrotor
        .linearize(0.0, &Spatial::default(), &hover)
        .discretized(PERIOD);
    let (s, gains) = regulator(&p, &q);
    println!("gains of the thrust in front");
    for (state, gain) in QuadrotorLinearization::STATES
        .iter()
        .zip(gains.row(0).iter())
    {
        println!("  {state:<18} {gain:8.4}");
    }
    let left = (weights() + p.transpose() * s * (p - q * gains) - s).norm() / s.norm();
    println!("left of the equation of Riccati: {left:.0e} of S");
    assert!(left < 1e-12);

    // vertical motion alone, in continuous time: k^2 = 4 / r, l^2 = 2 m k + 1 / r for the sum of
    // the thrusts, r = 0.5 / 4
    let stiff = (4.0_f64 / 0.125).sqrt();
    for (column, whole) in [(2, stiff), (8, (2.0 * 1.2 * stiff + 8.0).sqrt())] {
        println!(
            "{} {:.4}, at every instant {:.4}",
            QuadrotorLinearization::STATES[column],
            gains[(0, column)],
            whole / 4.0
        );
        assert!((gains[(0, column)] / whole * 4.0 - 1.0).abs() < 0.02);
    }

    let (states, sum) = recover(&quadrotor, &gains, 1e-3);
    let first = off(&states[0]);
    let known = first.dot(&(s * first));
    println!("from a small tilt it sums up to {sum:.6e}, by S {known:.6e}");
    assert!((sum / known - 1.0).abs() < 1e-5);

    let (states, _) = recover(&quadrotor, &gains, 60_f64.to_radians());
    let settled = settling(&states);
    println!("within 5 cm and 1° after {settled} s");
    assert!(settled < 2.5);
}
