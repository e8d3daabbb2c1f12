//! Motions of systems, with every method.

use newton_euler::constrained::Constrained;
use newton_euler::integrate::{
    Classical4, ClosedForm, DormandPrince, DormandPrince8, Fixed, IntegrationError, Method,
    Midpoint, Projected, RungeKutta, TaylorSeries, Tsitouras5, Verner9, cf4,
};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

use crate::dual::{Dual, lagrange};
use crate::systems::{
    Assembly, AssemblyState, CARTS, CENTERS, Chain, ChainState, DoublePendulum,
    DoublePendulumInput, DoublePendulumState, Geared, GearedState, LENGTH, MASSES, MOMENTS,
};
use crate::{assembled, lifted};

/// The largest difference of two lists of coordinates.
fn distance<S: Coordinates<Scalar = f64>>(a: &S, b: &S) -> f64 {
    let (a, b) = (a.coordinates(), b.coordinates());
    let pairs = a.as_ref().iter().zip(b.as_ref());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Kinetic less potential energy, of the velocities of the centers.
fn lagrangian([q, e]: &[Dual; 2], [dq, de]: &[Dual; 2]) -> Dual {
    let turn = *dq + *de;
    let number = |value: f64| Dual::from(value);
    let half = |mass: f64| number(0.5 * mass);
    let [near, far] = [(*q, *dq), (*q + *e, turn)].map(|(angle, rate)| {
        // where a point one meter along is, and its velocity
        let (sine, cosine) = (angle.sin(), angle.cos());
        ([sine, -cosine], [cosine * rate, sine * rate])
    });
    let square = |[x, y]: [Dual; 2]| x * x + y * y;
    let along = |[x, y]: [Dual; 2], length: f64| [x * number(length), y * number(length)];
    let sum = |[x, y]: [Dual; 2], [z, w]: [Dual; 2]| [x + z, y + w];
    let upper = (along(near.0, CENTERS[0]), along(near.1, CENTERS[0]));
    let lower = (
        sum(along(near.0, LENGTH), along(far.0, CENTERS[1])),
        sum(along(near.1, LENGTH), along(far.1, CENTERS[1])),
    );
    half(MOMENTS[0]) * *dq * *dq
        + half(MOMENTS[1]) * turn * turn
        + half(MASSES[0]) * square(upper.1)
        + half(MASSES[1]) * square(lower.1)
        - number(9.80665) * (number(MASSES[0]) * upper.0[1] + number(MASSES[1]) * lower.0[1])
}

/// The equations are Lagrange's.
#[test]
fn equations_of_the_double_pendulum() {
    let body = DoublePendulum::default();
    for k in 0..20 {
        let part = |n: i32| (f64::from(k * n) * 0.7).sin() * 3.0;
        let (q, dq) = ([part(1), part(2)], [part(3), part(4)]);
        let list = newton_euler::state::List([q[0], q[1], dq[0], dq[1]]);
        let state = DoublePendulumState::from_coordinates(&list);
        let input = DoublePendulumInput { motor: part(5) };
        let found = body.acceleration(0.0, &state, &input);
        let loads = lagrange(lagrangian, q, dq, [found.shoulder, found.elbow]);
        assert!(loads[0].abs() < 1e-12, "{loads:?}");
        assert!((loads[1] - input.motor).abs() < 1e-12, "{loads:?}");
    }
}

/// In equal steps: of half the length, the error is that of a higher power of two.
fn in_equal_steps<M: RungeKutta, B: Integrate<State: Coordinates<Scalar = f64>>>(
    body: &B,
    (start, end): (&B::State, &B::State),
    method: M,
    step: f64,
) {
    let error = |step| {
        let there = body.integrate(start).method(Fixed { method, step }).to(2.0);
        distance(&there.expect("an end"), end)
    };
    let [coarse, fine] = [error(step), error(step / 2.0)];
    let order = (coarse / fine).log2();
    #[expect(clippy::cast_precision_loss, reason = "small")]
    let least = M::ORDER as f64 - 0.5;
    assert!(order > least, "{method:?}: {coarse:e}, {fine:e}");
    assert!(coarse < 0.01, "{method:?}: {coarse:e}");
}

fn by_every_method<B: Integrate<State: Coordinates<Scalar = f64>>>(body: &B, start: &B::State) {
    let by = |tolerance| {
        let there = body.integrate(start).method(DormandPrince { tolerance });
        there.to(2.0).expect("an end")
    };
    let end = by(1e-15);
    let ends = (start, &end);
    in_equal_steps(body, ends, Verner9, 0.08);
    in_equal_steps(body, ends, DormandPrince8, 0.04);
    in_equal_steps(body, ends, Tsitouras5, 0.02);
    in_equal_steps(body, ends, Classical4, 0.02);
    in_equal_steps(body, ends, Midpoint, 0.002);
    let by_cf4 = |steps| cf4(body, start, &B::Input::default(), 0.0..2.0, steps);
    let [coarse, fine] = [100, 200].map(|steps| distance(&by_cf4(steps), &end));
    assert!((coarse / fine).log2() > 3.5, "cf4: {coarse:e}, {fine:e}");
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let error = distance(&by(tolerance), &end);
        assert!(error < 1000.0 * tolerance, "{tolerance:e}: {error:e}");
    }
}

#[test]
fn double_pendulum_by_every_method() {
    by_every_method(&DoublePendulum::default(), &lifted());
}

#[test]
fn joints_of_every_kind_by_every_method() {
    by_every_method(&Assembly { spin: 0.3 }, &assembled());
}

#[test]
fn energy_is_kept() {
    let (body, start) = (DoublePendulum::default(), lifted());
    let end = body.integrate(&start).tolerance(1e-14).to(20.0).unwrap();
    let error = (body.energy(&end) - body.energy(&start)).abs();
    assert!(error < 1e-11, "{error:e}");
    assert!(distance(&start, &end) > 0.1);
}

fn row_of_carts() -> ChainState {
    let mut carts = [Slide::default(); CARTS];
    (carts[0].position, carts[7].velocity) = (1.0, -2.0);
    ChainState::of(&carts)
}

fn ends_where_its_modes_do<M: Method<Chain>>(method: M, limit: f64) {
    let start = row_of_carts();
    for end in [40.0, -3.0] {
        let expected = Chain.flow(&start, end);
        let motion = || Chain.integrate(&start).method(method);
        let error = distance(&motion().to(end).unwrap(), &expected);
        assert!(error < limit, "{error:e}");
        let samples: Vec<_> = motion().samples(end, 0.3).map(Result::unwrap).collect();
        assert_eq!(samples.len(), if end > 0.0 { 134 } else { 11 });
        for sample in samples {
            let error = distance(&sample.state, &Chain.flow(&start, sample.time));
            assert!(error < limit, "{}: {error:e}", sample.time);
        }
    }
}

/// Forty coordinates, along series too: these are held against the rates of velocities, which are
/// the second half.
#[test]
fn forty_coordinates() {
    ends_where_its_modes_do(ClosedForm, 1e-12);
    ends_where_its_modes_do(TaylorSeries { tolerance: 1e-13 }, 1e-11);
    ends_where_its_modes_do(TaylorSeries { tolerance: 1e-6 }, 1e-4);
    ends_where_its_modes_do(DormandPrince { tolerance: 1e-13 }, 1e-11);
    let fixed = Fixed {
        method: Verner9,
        step: 0.05,
    };
    ends_where_its_modes_do(fixed, 1e-10);
    let series = Chain.series::<12>(0.0, &row_of_carts(), &());
    let error = distance(&series.after(0.01), &Chain.flow(&row_of_carts(), 0.01));
    assert!(error < 1e-14, "{error:e}");
}

/// Events, samples and controllers see the joints by their names.
#[test]
fn events_and_controllers() {
    let (body, start) = (DoublePendulum::default(), lifted());
    let straight = |_: f64, state: &DoublePendulumState<f64>| state.elbow.angle;
    let events: Vec<_> = body.integrate(&start).events(3.0, straight).collect();
    assert!(events.len() > 3);
    let mut last = 0.0;
    for event in events {
        let event = event.unwrap();
        assert!(event.state.elbow.angle.abs() < 1e-11 && event.time > last);
        last = event.time;
        let there = body.integrate(&start).to(last).unwrap();
        assert!(distance(&there, &event.state) < 1e-8);
    }
    let damped = |_: f64, state: &DoublePendulumState<f64>| DoublePendulumInput {
        motor: -0.2 * state.elbow.angular_velocity,
    };
    let end = body
        .integrate(&start)
        .control(0.01, damped)
        .to(30.0)
        .unwrap();
    assert!(body.energy(&end) < body.energy(&start) - 1.0);
    let held = body
        .integrate(&start)
        .input(DoublePendulumInput { motor: 0.4 });
    let free = body.integrate(&start).to(1.0).unwrap();
    assert!(distance(&held.to(1.0).unwrap(), &free) > 0.1);
}

/// Attitudes and axes of joints stay unit over many steps.
#[test]
fn attitudes_stay_unit() {
    let (body, start) = (Assembly { spin: 0.3 }, assembled());
    let method = Fixed {
        method: DormandPrince8,
        step: 0.02,
    };
    let end: AssemblyState<f64> = body.integrate(&start).method(method).to(20.0).unwrap();
    for norm in [
        end.orbit.attitude.as_ref().norm(),
        end.ball.attitude.as_ref().norm(),
        end.needle.axis.norm(),
    ] {
        assert!((norm - 1.0).abs() < 1e-15, "{norm}");
    }
    let along = end.needle.axis.dot(&end.needle.axis_rate);
    assert!(
        along.abs() < 1e-14 * end.needle.axis_rate.norm(),
        "{along:e}"
    );
}

#[test]
fn constraints_between_joints() {
    let mut start = GearedState {
        first: Hinge {
            angle: 0.4,
            angular_velocity: 1.0,
        },
        ..GearedState::default()
    };
    let refused = Geared.integrate(&start).to(5.0).unwrap_err();
    assert!(
        matches!(refused, IntegrationError::Inconsistent { .. }),
        "{refused}"
    );
    Geared.project(0.0, &mut start, &()).unwrap();
    let end = Geared.integrate(&start).tolerance(1e-13);
    let end = end.to(5.0).unwrap();
    let [violation] = Geared.violations(5.0, &end, &());
    assert!(violation.position.unwrap().abs() < 1e-14 && violation.velocity.abs() < 1e-14);
    let free = Geared
        .integrate(&start)
        .method(DormandPrince { tolerance: 1e-13 });
    let error = distance(&free.to(5.0).unwrap(), &end);
    assert!(error < 1e-9, "{error:e}");
    let steps = Projected(Fixed {
        method: DormandPrince8,
        step: 0.02,
    });
    let error = distance(
        &Geared.integrate(&start).method(steps).to(5.0).unwrap(),
        &end,
    );
    assert!(error < 1e-9, "{error:e}");
}

/// An error has the last state that was good, and says when.
#[test]
fn what_does_not_come_to_an_end() {
    let start = DoublePendulumState {
        shoulder: Hinge {
            angle: f64::NAN,
            angular_velocity: 0.0,
        },
        ..lifted()
    };
    let error = DoublePendulum::default()
        .integrate(&start)
        .to(1.0)
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "a coordinate of the initial state is NaN: it must be finite"
    );
}
