//! A short run of the example `long_runs`: laws of error growth, conserved quantities, a
//! satellite's week.
#![allow(missing_docs, reason = "tests")]
#![allow(dead_code, reason = "of the example not all is looked at")]

#[path = "../examples/long_runs/bodies.rs"]
mod bodies;
#[path = "../examples/long_runs/growth.rs"]
mod growth;
#[path = "../examples/long_runs/march.rs"]
mod march;
#[path = "../examples/long_runs/problem.rs"]
mod problem;
mod reference;
#[path = "../examples/long_runs/week.rs"]
mod week;

use newton_euler::integrate::TaylorSeries;
use newton_euler::prelude::*;

use bodies::{FreeBody, LagrangeTop};
use growth::{Growth, Row, follow};

/// 2ⁿ steps of a method.
fn free(method: &str, doublings: u32) -> Growth {
    let body = FreeBody::default();
    let ways = march::all();
    let way = ways.iter().find(|way| way.name == method).unwrap();
    follow(&problem::free(&body), way, doublings)
}

fn last(growth: &Growth) -> [f64; 3] {
    growth.rows.last().unwrap().errors.map(Option::unwrap)
}

#[test]
fn exponents_of_power_laws() {
    for exponent in [0.5, 1.0, 2.0] {
        let row = |doubling: i32| Row {
            steps: 1 << doubling,
            errors: [
                Some(1e-13 * 2_f64.powf(exponent * f64::from(doubling))),
                None,
                Some(1e-16),
            ],
        };
        let growth = Growth {
            problem: "",
            method: "",
            step: 1.0,
            cost: 0.0,
            rows: (0..20).map(row).collect(),
            expected: [exponent; 3],
        };
        assert!((growth.exponent(0).unwrap() - exponent).abs() < 1e-12);
        // what is not known, or below rounding, has none
        assert_eq!([growth.exponent(1), growth.exponent(2)], [None; 2]);
    }
}

#[test]
fn series_leave_rounding() {
    let growth = free("Taylor 16", 13);
    let [energy, momentum, attitude] = last(&growth);
    assert!(
        energy < 2e-15 && momentum < 5e-15 && attitude < 2e-12,
        "{energy:e} {momentum:e} {attitude:e}"
    );
    let law = growth.exponent(2).unwrap();
    assert!((1.0..1.8).contains(&law), "{law}");
}

#[test]
fn runge_kutta_drifts() {
    let growth = free("Runge-Kutta 5", 16);
    let [energy, attitude] = [0, 2].map(|quantity| growth.exponent(quantity).unwrap());
    assert!(
        (energy - 1.0).abs() < 0.1 && (attitude - 2.0).abs() < 0.3,
        "{energy} {attitude}"
    );
}

#[test]
fn midpoint_rule_keeps_energy() {
    let growth = free("midpoint rule", 13);
    let [energy, momentum, _] = last(&growth);
    assert!(energy < 1e-15, "{energy:e}");
    // the momentum turns to and fro, by as much after ten steps as after ten thousand
    let early = growth.rows[7].errors[1].unwrap();
    assert!(momentum < 2.0 * early, "{early:e} {momentum:e}");
    let law = growth.exponent(2).unwrap();
    assert!((law - 1.0).abs() < 0.2, "{law}");
}

/// The attitudes that are known come from two routes: 60-digit arithmetic, and the closed form, whose error is that of its inputs.
#[test]
fn closed_form_after_half_a_year() {
    rigid_body!(Free {
        motion: rotation,
        inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
        outputs: [flow],
    });
    let body = FreeBody::default();
    let problem = problem::free(&body);
    let time = 2_f64.powi(24);
    for (number, start) in problem.starts.iter().enumerate() {
        let [_, _, off] = problem.errors(number, time, &Free::default().flow(start, time));
        // 2⁻⁵³ of the angle turned, times four
        assert!(off.unwrap() < 4.0 * 1.2e-16 * 3.2 * time, "{off:?}");
    }
    // and some attitudes of the top, by series
    let top = LagrangeTop::default();
    let problem = problem::lagrange(&top);
    for (number, start) in problem.starts.iter().enumerate() {
        let motion = top
            .integrate(start)
            .method(TaylorSeries { tolerance: 1e-15 });
        let [_, _, off] = problem.errors(number, 64.0, &motion.to(64.0).unwrap());
        assert!(off.unwrap() < 1e-12, "{off:?}");
    }
}

#[test]
fn satellite_keeps_its_energy_for_a_week() {
    let change = week::change::<TaylorSeries>(week::WEEK, 1e-15).unwrap();
    assert!(change < 1e-12, "{change:e}");
    // by default 1e-9 a step
    let coarse = week::change::<TaylorSeries>(week::WEEK, 1e-9).unwrap();
    assert!((1e-12..1e-7).contains(&coarse), "{coarse:e}");
}

/// Gravity does work: it is Jacobi's integral that stays.
#[test]
fn energy_alone_is_not_kept() {
    let (satellite, start) = (week::Satellite::default(), week::start());
    let energy = |time, state: &Rotation| {
        satellite.kinetic_energy(state) + satellite.potential_energy(time, state, &())
    };
    let end = satellite
        .integrate(&start)
        .tolerance(1e-12)
        .to(5000.0)
        .unwrap();
    let change = energy(5000.0, &end) / energy(0.0, &start) - 1.0;
    assert!(change.abs() > 1e-3, "{change:e}");
}

#[test]
fn without_loads_the_week_ends_where_the_closed_form_does() {
    let [angle, energy] = week::coasting(week::WEEK, 1e-15).unwrap();
    assert!(angle < 2e-11 && energy < 1e-13, "{angle:e} {energy:e}");
}
