//! The example `work_precision`: its problems reach their known final states, and its times are
//! read correctly.
#![allow(missing_docs, reason = "tests")]
#![allow(dead_code, reason = "of the example not all is looked at")]

#[path = "../examples/work_precision/bodies.rs"]
mod bodies;
#[path = "../examples/work_precision/peers/buss.rs"]
mod buss;
#[path = "../examples/work_precision/by_hand.rs"]
mod by_hand;
#[path = "../benches/measure/clock.rs"]
mod clock;
#[path = "../examples/work_precision/distance.rs"]
mod distance;
#[path = "../examples/work_precision/peers/jolt.rs"]
mod jolt;
#[path = "../examples/work_precision/measure.rs"]
mod measure;
#[path = "../examples/work_precision/method.rs"]
mod method;
#[path = "../examples/work_precision/peers/moser_veselov.rs"]
mod moser_veselov;
#[path = "../examples/work_precision/problem.rs"]
mod problem;
mod reference;
#[path = "../examples/work_precision/peers/splitting.rs"]
mod splitting;

use nalgebra::Vector3;
use newton_euler::integrate;
use newton_euler::prelude::*;

use distance::Distance;
use measure::{Curve, Point};
use method::{Method, Way};
use problem::{Problem, flying, swinging, turning};

/// The error at the end, by series of a tolerance that leaves rounding.
fn error<B: Taylor<State: Distance, Input = ()>>(problem: &Problem<B>) -> f64 {
    let times = 0.0..problem.seconds;
    let end = integrate::taylor(&problem.body, &problem.start, &(), times, 1e-15);
    let Ok(end) = end else {
        return f64::NAN;
    };
    end.distance(&problem.end)
}

#[test]
fn problems_end_where_they_are_known_to() {
    let errors = [
        error(&flying("quadrotor", bodies::Quadrotor::default())),
        error(&flying("satellite", bodies::Satellite::default())),
        error(&turning("heavy_asym", bodies::HeavyTop::default())),
        error(&turning(
            "lagrange_nutation",
            bodies::LagrangeTop::default(),
        )),
        error(&turning(
            "pendulum_planar",
            bodies::PendulumInSpace::default(),
        )),
        error(&swinging("pendulum", bodies::Pendulum::default())),
    ];
    assert!(errors.iter().all(|error| *error < 1e-13), "{errors:?}");
}

/// The orders of the peers with steps on a body: of their errors at a step and at half of it.
fn orders<L: by_hand::Load>(problem: &Problem<by_hand::Turning<L>>) {
    let peers = [
        (splitting::method(problem), 2.0),
        (buss::method(problem), 2.0),
        (moser_veselov::method(problem), 2.0),
        (jolt::method(problem), 1.0),
    ];
    for (Method { name, way }, expected) in peers {
        let Way::Fixed(end) = way else {
            panic!("{name} has steps");
        };
        let steps: u32 = if expected < 2.0 { 50_000 } else { 2000 };
        let error = |steps| end(steps).distance(&problem.end);
        let order = (error(steps) / error(2 * steps)).log2();
        assert!((order - expected).abs() < 0.1, "{name}: {order}");
    }
}

#[test]
fn peers_with_steps_have_their_orders() {
    let moments = Vector3::new(0.6, 0.8, 1.0);
    let free = turning("asymmetric_free", bodies::AsymmetricFree::default());
    orders(&free.of(by_hand::Turning {
        moments,
        load: by_hand::Free,
    }));
    let heavy = turning("heavy_asym", bodies::HeavyTop::default());
    let load = by_hand::Weight(Vector3::z());
    orders(&heavy.of(by_hand::Turning { moments, load }));
}

fn point(time: f64, error: f64) -> Point {
    Point {
        effort: 1.0,
        time,
        error,
    }
}

/// Of an error that is one over the square of the time; what others better in both does not count.
#[test]
fn times_lie_between_the_best_points() {
    let curve = Curve {
        problem: String::new(),
        method: String::new(),
        points: vec![
            point(1e1, 1e-2),
            point(1e3, 1e-6),
            point(1e2, 1e-1),
            point(1e5, 1e-5),
        ],
    };
    let to = |error| curve.time_to(error).unwrap();
    assert!((to(1e-4) / 1e2 - 1.0).abs() < 1e-12);
    assert!((to(1e-1) / 1e1 - 1.0).abs() < 1e-12); // the fastest there is
    assert_eq!(curve.time_to(1e-7), None);
    assert_eq!(curve.best().len(), 2);
}
