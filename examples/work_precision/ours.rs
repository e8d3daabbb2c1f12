//! The methods of this library. A new one is a function here, and a line in the lists.

use std::hint::black_box;

use newton_euler::integrate::{self, Motion};
use newton_euler::prelude::*;

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
pub fn smooth<B: Taylor<Input = ()>>(problem: &Problem<B>) -> Vec<Method<'_, B::State>> {
    vec![
        taylor(problem),
        taylor_steps::<B, 9>("Taylor 8, fixed steps", problem),
        taylor_steps::<B, 17>("Taylor 16, fixed steps", problem),
        cf4(problem),
    ]
}

fn taylor<B: Taylor<Input = ()>>(problem: &Problem<B>) -> Method<'_, B::State> {
    let Problem {
        body,
        start,
        seconds,
        ..
    } = problem;
    Method::adaptive("Taylor", |tolerance| {
        integrate::taylor(body, black_box(start), &(), 0.0..*seconds, tolerance).ok()
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
