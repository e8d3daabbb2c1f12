//! The crate `differential-equations`: states of thirteen numbers, with right-hand sides by hand or
//! from the description.

use std::hint::black_box;

use differential_equations::prelude::{ExplicitRungeKutta, IVP, ODE};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::{integrate, prelude::*};

use crate::bodies::{General, GeneralInput};
use crate::by_hand::{Space, full};
use crate::paired::paired;
use crate::table::Table;
use crate::{distance, state};

const STEPS: u32 = 1000;
const STEP: f64 = 1e-3;

/// Position, velocity, attitude (x, y, z, w), angular velocity.
type Numbers = [f64; 13];

/// The motion of a body under a constant input.
struct Motion<B: RigidBody> {
    body: B,
    input: B::Input,
}

impl<B: RigidBody<Scalar = f64, State = Spatial>> ODE<f64, Numbers> for Motion<B> {
    #[inline(always)]
    fn diff(&self, time: f64, numbers: &Numbers, rates: &mut Numbers) {
        let state = unpacked(numbers);
        let SpatialAcceleration { linear, angular } =
            self.body.acceleration(time, &state, &self.input);
        // q' = q w / 2
        let turning =
            state.attitude.into_inner() * Quaternion::from_imag(state.angular_velocity * 0.5);
        *rates = packed(&state.velocity, &linear, &turning, &angular);
    }
}

/// The attitude is used as it is, without normalization.
#[inline(always)]
fn unpacked(&[x, y, z, u, v, w, i, j, k, real, p, q, r]: &Numbers) -> Spatial {
    Spatial {
        position: Vector3::new(x, y, z),
        velocity: Vector3::new(u, v, w),
        attitude: UnitQuaternion::new_unchecked(Quaternion::new(real, i, j, k)),
        angular_velocity: Vector3::new(p, q, r),
    }
}

#[inline(always)]
fn packed(
    first: &Vector3<f64>,
    second: &Vector3<f64>,
    third: &Quaternion<f64>,
    fourth: &Vector3<f64>,
) -> Numbers {
    let ([x, y, z], [u, v, w]): ([f64; 3], [f64; 3]) = ((*first).into(), (*second).into());
    let ([i, j, k, real], [p, q, r]): ([f64; 4], [f64; 3]) =
        (third.coords.into(), (*fourth).into());
    [x, y, z, u, v, w, i, j, k, real, p, q, r]
}

fn start() -> (Spatial, Numbers) {
    let Spatial {
        position,
        attitude,
        velocity,
        angular_velocity,
    } = state(0.7);
    let numbers = packed(&position, &velocity, &attitude, &angular_velocity);
    (state(0.7), numbers)
}

/// The state after `STEPS` steps of the classical Runge-Kutta method.
fn runge_kutta(motion: &impl ODE<f64, Numbers>) -> Numbers {
    let end = STEP * f64::from(STEPS);
    let solution = IVP::ode(motion, 0.0, end, black_box(start().1))
        .method(ExplicitRungeKutta::rk4(STEP))
        .solve();
    let solution = solution.expect("a regular motion");
    *solution.last().expect("an end").1
}

/// The state after the same time, almost to rounding.
fn reference(motion: &impl ODE<f64, Numbers>) -> Spatial {
    let end = STEP * f64::from(STEPS);
    let solution = IVP::ode(motion, 0.0, end, start().1)
        .method(ExplicitRungeKutta::dop853().rtol(1e-13).atol(1e-13))
        .solve();
    let solution = solution.expect("a regular motion");
    unpacked(solution.last().expect("an end").1)
}

pub fn measure(table: &mut Table) {
    let force = Vector3::new(4.0, -2.5, 10.0);
    let ours = Motion {
        body: General::<f64>::default(),
        input: GeneralInput { force },
    };
    let by_hand = Motion {
        body: Space::new(full()),
        input: force,
    };

    let numbers: Vec<Numbers> = (0..128_u32)
        .map(|i| {
            let Spatial {
                position,
                attitude,
                velocity,
                angular_velocity,
            } = state(f64::from(i) * 0.37);
            packed(&position, &velocity, &attitude, &angular_velocity)
        })
        .collect();
    let (mut first, mut second) = (numbers.clone(), numbers.clone());
    right_hand_sides(&ours, &numbers, &mut first);
    right_hand_sides(&by_hand, &numbers, &mut second);
    for (one, other) in first.iter().flatten().zip(second.iter().flatten()) {
        assert!((one - other).abs() < 1e-13, "{one} is not {other}");
    }
    let times = paired(
        128,
        || right_hand_sides(&ours, &numbers, &mut first),
        || right_hand_sides(&by_hand, &numbers, &mut second),
    );
    table.row("right-hand side, against by hand".into(), times, None);

    let exact = reference(&by_hand);
    let cf4 = || {
        let (state, end) = (black_box(start().0), STEP * f64::from(STEPS));
        integrate::cf4(&ours.body, &state, &ours.input, 0.0..end, STEPS as usize)
    };
    println!("errors after 1 s, steps of 1 ms: m, m/s, rad, rad/s, the largest");
    for (what, end) in [
        (
            "RK4 of differential-equations, generated",
            unpacked(&runge_kutta(&ours)),
        ),
        (
            "RK4 of differential-equations, by hand",
            unpacked(&runge_kutta(&by_hand)),
        ),
        ("cf4", cf4()),
    ] {
        let error = distance(&end, &exact);
        assert!(error < 1e-9, "{what}: {error:e}");
        println!("  {what:<44}{error:.1e}");
    }

    let rk4 = || {
        black_box(runge_kutta(&by_hand));
    };
    let times = paired(
        STEPS,
        || {
            black_box(runge_kutta(&ours));
        },
        rk4,
    );
    table.row("a step of their RK4, against by hand".into(), times, None);
    let times = paired(
        STEPS,
        || {
            black_box(cf4());
        },
        rk4,
    );
    table.row(
        "a step of cf4, against their RK4 by hand".into(),
        times,
        None,
    );
}

fn right_hand_sides(motion: &impl ODE<f64, Numbers>, numbers: &[Numbers], rates: &mut [Numbers]) {
    for (numbers, rates) in black_box(numbers).iter().zip(&mut *rates) {
        motion.diff(0.0, numbers, rates);
    }
    black_box(rates);
}
