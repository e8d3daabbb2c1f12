//! A cart moves an upright pole to another place, under model-predictive control: the motor pushes
//! 4 N at most.
//!
//! Twenty times a second, the controller recomputes the forces of the next second and applies the
//! first one. The forces minimize
//!
//! ```text
//! sum of x.W x + r u^2  +  x_N.S x_N,    x_(k+1) = P x_k + q u_k,    |u_k| <= 4 N
//! ```
//!
//! P and q follow from the description by `linearize` and `discretized`. S is the cost of the
//! motion from there on, by Riccati's equation. If the states are written as sums of the forces,
//! this is a quadratic program in the forces alone, and the crate `clarabel` solves it. The
//! simulated system is the full one, not its linearization.
//!
//! Asserts: the bound holds, and is reached; each solution satisfies the Karush–Kuhn–Tucker
//! conditions; where no bound is near, the force is that of the linear-quadratic regulator; the
//! pole stands at the new place. With the regulator alone, its force clipped to the bound, the pole
//! falls.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus, SupportedConeT,
};
use newton_euler::nalgebra::{RowSVector, SMatrix, SVector};
use newton_euler::prelude::*;

rigid_system!(CartPole {
    doc: "A pole on a pin of a cart that runs on a rail; angles are from the upright.",
    motion: planar,
    inputs: [force[N]],
    bodies: [
        cart {
            mass: 0.8[kg],
            inertia: 0.01[kg * m ^ 2]
        },
        pole {
            mass: 0.2[kg],
            inertia: 0.006[kg * m ^ 2],
            points: [pin = (0, -0.3)[m]]
        },
    ],
    joints: [
        rail = prismatic(world(0, 0), cart.G, body(1, 0)),
        hinge = revolute(cart.G, pole.pin),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    drives: [motor = force.on(rail)],
    outputs: [linearization],
});

const PERIOD: f64 = 0.05;
const HORIZON: usize = 20;
/// The largest force of the motor [N].
const MOST: f64 = 4.0;
const EFFORT: f64 = 0.1;

type States = SMatrix<f64, 4, 4>;
type State = SVector<f64, 4>;
type Forces = SVector<f64, HORIZON>;
type Hessian = SMatrix<f64, HORIZON, HORIZON>;

/// W: weights of position, angle and their rates.
fn weights() -> States {
    States::from_diagonal(&State::new(10.0, 10.0, 1.0, 1.0))
}

/// S, and the gains of the regulator u = -k x without bounds.
fn regulator(p: &States, q: &State) -> (States, RowSVector<f64, 4>) {
    let mut s = weights();
    for _period in 0..2000 {
        let gains = q.transpose() * s * p / (EFFORT + q.dot(&(s * q)));
        s = weights() + p.transpose() * s * (p - q * gains);
    }
    (s, q.transpose() * s * p / (EFFORT + q.dot(&(s * q))))
}

/// The quadratic program: minimize half of u.H u + u.G x.
struct Program {
    hessian: Hessian,
    slopes: SMatrix<f64, HORIZON, 4>,
}

impl Program {
    /// The state after k periods is `P^k x + sum of P^(k-1-j) q u_j`.
    fn new(p: &States, q: &State, s: &States) -> Self {
        let mut free = States::identity();
        let mut pushed = SMatrix::<f64, 4, HORIZON>::zeros();
        let (mut hessian, mut slopes) = (Hessian::identity() * EFFORT, SMatrix::zeros());
        for k in 1..=HORIZON {
            free = p * free;
            pushed = p * pushed;
            pushed.set_column(k - 1, q);
            let weights = if k == HORIZON { *s } else { weights() };
            hessian += pushed.transpose() * weights * pushed;
            slopes += pushed.transpose() * weights * free;
        }
        Self { hessian, slopes }
    }

    /// The forces from a state on.
    fn solve(&self, x: &State) -> Forces {
        let linear: Vec<f64> = (self.slopes * x).iter().copied().collect();
        // u <= MOST, -u <= MOST
        let rows = Hessian::identity();
        let bounds: Vec<[f64; HORIZON]> = [rows, -rows]
            .iter()
            .flat_map(|rows| rows.row_iter().map(|row| row.transpose().into()))
            .collect();
        let upper: Vec<[f64; HORIZON]> = (self.hessian.upper_triangle().row_iter())
            .map(|row| row.transpose().into())
            .collect();
        let cones: [SupportedConeT<f64>; 1] = [NonnegativeConeT(2 * HORIZON)];
        let settings = DefaultSettings {
            verbose: false,
            tol_gap_abs: 1e-12,
            tol_gap_rel: 1e-12,
            tol_feas: 1e-12,
            ..DefaultSettings::default()
        };
        let mut solver = DefaultSolver::new(
            &CscMatrix::from(&upper),
            &linear,
            &CscMatrix::from(&bounds),
            &[MOST; 2 * HORIZON],
            &cones,
            settings,
        )
        .expect("sizes fit");
        solver.solve();
        assert_eq!(solver.solution.status, SolverStatus::Solved);
        Forces::from_column_slice(&solver.solution.x)
    }

    /// The distance of forces from the optimum: the gradient, except where a bound opposes it.
    fn residual(&self, x: &State, forces: &Forces) -> f64 {
        let gradient = self.hessian * forces + self.slopes * x;
        let moved =
            (forces - gradient / self.hessian[(0, 0)]).map(|force| force.clamp(-MOST, MOST));
        (moved - forces).amax()
    }
}

/// The deviation of a state from the pole upright at the new place.
fn off(state: &CartPoleState) -> State {
    let (rail, hinge) = (&state.rail, &state.hinge);
    State::new(
        rail.position,
        hinge.angle,
        rail.velocity,
        hinge.angular_velocity,
    )
}

/// The motion of the cart from 1.5 m off the target, under a force controller, with the state and
/// force at each instant.
fn drive<L>(
    system: &CartPole,
    mut controller: impl FnMut(&State) -> (f64, L),
) -> (Vec<(f64, State, L)>, State) {
    let rail = Slide {
        position: -1.5,
        velocity: 0.0,
    };
    let start = CartPoleState {
        rail,
        ..CartPoleState::default()
    };
    let mut log = Vec::new();
    let motion = system.integrate(&start).control(PERIOD, |time, state| {
        let x = off(state);
        let (force, told) = controller(&x);
        log.push((time, x, told));
        CartPoleInput { force }
    });
    let end = off(&motion.to(5.0).expect("it moves"));
    (log, end)
}

fn main() {
    let system = CartPole::default();
    let free = CartPoleInput { force: 0.0 };
    let upright = system.linearize(0.0, &CartPoleState::default(), &free);
    let (p, q) = upright.discretized(PERIOD);
    let (s, gains) = regulator(&p, &q);
    let program = Program::new(&p, &q, &s);

    let (log, end) = drive(&system, |x| {
        let forces = program.solve(x);
        (forces[0], forces)
    });
    println!("  t/s    off/m   tilt/°   force/N");
    let (mut bound, mut regulated) = (0, 0);
    for (step, (time, x, forces)) in log.iter().enumerate() {
        let force = forces[0];
        if step % 4 == 0 {
            let (place, tilt) = (x[0], x[1].to_degrees());
            println!("{time:5.2} {place:8.4} {tilt:8.3} {force:9.5}");
        }
        assert!(forces.amax() < MOST + 1e-9);
        assert!(program.residual(x, forces) < 1e-5);

        if force.abs() > 0.999 * MOST {
            bound += 1;
        }
        if forces.amax() < 0.9 * MOST {
            regulated += 1;
            assert!((force + (gains * x)[0]).abs() < 1e-5);
        }
    }
    println!(
        "{bound} of {} forces at their bound, {regulated} by the regulator",
        log.len()
    );
    assert!(bound >= 5 && regulated >= 50);
    println!("after 5 s off by {:.0e} m and {:.0e} rad", end[0], end[1]);
    assert!(end.amax() < 1e-3);

    let (_, end) = drive(&system, |x| ((-(gains * x)[0]).clamp(-MOST, MOST), ()));
    let tilt = end[1].to_degrees();
    println!("the regulator with its force cut off at 4 N ends at {tilt:.0}°: the pole has fallen");
    assert!(tilt.abs() > 90.0);
}
