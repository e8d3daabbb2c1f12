//! The methods of this library. A new one is a function here, and a line in the lists.

use std::hint::black_box;

use newton_euler::integrate::{
    self, Classical4, DormandPrince, DormandPrince8, Fixed, Midpoint, Motion, RungeKutta,
    TaylorSeries, Tolerant, Tsitouras5, Verner, Verner9,
};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

use crate::method::Method;
use crate::problem::Problem;

/// The motion in closed form, set up and evaluated once.
pub fn flow<B: Flow>(problem: &Problem<B>) -> Method<'_, B::State> {
    Method::closed("closed form", || {
        problem
            .body
            .flow(black_box(&problem.start), problem.seconds)
    })
}

/// All methods for a body that has series.
pub fn smooth<B: Taylor<Input = ()> + Integrate>(
    problem: &Problem<B>,
) -> Vec<Method<'_, B::State>> {
    let mut methods = stepping(problem);
    methods.insert(0, adaptive::<B, TaylorSeries>("Taylor", problem));
    methods.insert(3, taylor_steps::<B, 17>("Taylor 16, fixed steps", problem));
    methods
}

/// All methods for any body.
pub fn stepping<B>(problem: &Problem<B>) -> Vec<Method<'_, B::State>>
where
    B: Integrate<Input = (), State: Coordinates<Scalar = f64>>,
{
    vec![
        adaptive::<B, DormandPrince>("DOP853", problem),
        adaptive::<B, Verner>("Verner 9(8)", problem),
        steps("Runge-Kutta 9, fixed steps", Verner9, problem),
        steps("Runge-Kutta 8, fixed steps", DormandPrince8, problem),
        steps("Runge-Kutta 5, fixed steps", Tsitouras5, problem),
        steps("Runge-Kutta 4, fixed steps", Classical4, problem),
        steps("midpoint rule", Midpoint, problem),
        cf4(problem),
    ]
}

fn adaptive<'p, B, M>(name: &'static str, problem: &'p Problem<B>) -> Method<'p, B::State>
where
    B: Integrate<Input = ()>,
    M: integrate::Method<B> + Tolerant,
{
    let Problem {
        body,
        start,
        seconds,
        ..
    } = problem;
    Method::adaptive(name, move |tolerance| {
        let method = M::with_tolerance(tolerance);
        body.integrate(black_box(start))
            .method(method)
            .to(*seconds)
            .ok()
    })
}

fn steps<'p, B, M>(name: &'static str, method: M, problem: &'p Problem<B>) -> Method<'p, B::State>
where
    B: Integrate<Input = (), State: Coordinates>,
    M: RungeKutta + 'p,
{
    let Problem {
        body,
        start,
        seconds,
        ..
    } = problem;
    Method::fixed(name, move |steps| {
        let step = seconds / f64::from(steps);
        let motion = body
            .integrate(black_box(start))
            .method(Fixed { method, step });
        // what is not finite stays where it was, and counts as not arrived
        motion
            .to(*seconds)
            .unwrap_or_else(|error| error.state().clone())
    })
}

fn taylor_steps<'p, B: Taylor<Input = ()>, const N: usize>(
    name: &'static str,
    problem: &'p Problem<B>,
) -> Method<'p, B::State> {
    Method::fixed(name, |steps| {
        let mut motion = Motion::<B, N>::new(&problem.body, 0.0, black_box(&problem.start));
        for _ in 0..steps {
            // what is not finite stays where it is, and counts as not arrived
            let _ = motion.step(problem.seconds / f64::from(steps), &());
        }
        motion.state()
    })
}

fn cf4<B: RigidBody<Scalar = f64, Input = ()>>(problem: &Problem<B>) -> Method<'_, B::State> {
    Method::fixed("CF4", |steps| {
        let times = 0.0..problem.seconds;
        integrate::cf4(
            &problem.body,
            black_box(&problem.start),
            &(),
            times,
            steps as usize,
        )
    })
}
