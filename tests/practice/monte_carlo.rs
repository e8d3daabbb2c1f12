//! Where balls land that are thrown with errors: many runs, and a table of them in a file.

use std::fmt::Write as _;

use newton_euler::ensemble::Ensemble;
use newton_euler::prelude::*;

rigid_body!(Ball::<T> {
    doc: "A ball in air that resists with its velocity.",
    motion: planar_translation,
    params: [mass_of_ball[kg], drag[N * s / m]],
    mass: mass_of_ball,
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    forces: [resistance = -drag * velocity],
});

const RUNS: u32 = 400;
const SECONDS: f64 = 1.5;

/// Between 0 and 1, spread evenly.
fn spread(index: u32, irrational: f64) -> f64 {
    (f64::from(index) * irrational).fract()
}

fn throw(index: u32) -> (BallParams<f64>, PlanarTranslation) {
    let params = BallParams {
        mass_of_ball: 0.15 + 0.02 * spread(index, 2.0_f64.sqrt()),
        drag: 0.04 + 0.03 * spread(index, 3.0_f64.sqrt()),
    };
    let (speed, angle) = (
        18.0 + 2.0 * spread(index, 5.0_f64.sqrt()),
        0.7 + 0.1 * spread(index, 7.0_f64.sqrt()),
    );
    let state = PlanarTranslation {
        velocity: [speed * angle.cos(), speed * angle.sin()].into(),
        ..PlanarTranslation::default()
    };
    (params, state)
}

/// `v = v0 e + (e - 1) g T`, `x = (v0 + g T) T (1 - e) - g T t` with T = m / c and e = exp(-t / T).
fn closed_form(index: u32) -> [f64; 2] {
    let (params, start) = throw(index);
    let lag = params.mass_of_ball / params.drag;
    let gone = lag * -(-SECONDS / lag).exp_m1();
    let fall = 9.81 * lag;
    [
        start.velocity.x * gone,
        (start.velocity.y + fall) * gone - fall * SECONDS,
    ]
}

#[test]
fn a_table_of_runs_goes_to_a_file_and_back() {
    let mut balls = Ensemble::<Ball<f64>>::with_params((0..RUNS).map(throw)).expect("possible");
    balls
        .integrate()
        .tolerance(1e-11)
        .to(SECONDS)
        .expect("they fly");

    let mut table = String::from("run,mass,drag,x,y\n");
    for run in 0..RUNS {
        let (params, _) = throw(run);
        let end = balls.state(run as usize).position;
        let BallParams { mass_of_ball, drag } = params;
        writeln!(table, "{run},{mass_of_ball},{drag},{},{}", end.x, end.y).expect("text");
    }
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("monte_carlo.csv");
    std::fs::write(&path, table).expect("a folder for it");

    let read = std::fs::read_to_string(&path).expect("it is there");
    let rows = read.lines().skip(1).map(|line| {
        let cells = line.split(',').map(|cell| cell.parse().expect("a number"));
        let cells: Vec<f64> = cells.collect();
        [cells[3], cells[4]]
    });
    let rows: Vec<[f64; 2]> = rows.collect();
    assert_eq!(rows.len(), RUNS as usize);
    for (run, found) in (0..RUNS).zip(&rows) {
        let known = closed_form(run);
        let end = balls.state(run as usize).position;
        assert_eq!(*found, [end.x, end.y], "as it was written");
        for (found, known) in found.iter().zip(known) {
            assert!((found - known).abs() < 1e-9, "{run}: {found} {known}");
        }
    }
    let mean = |of: &dyn Fn(u32) -> f64| (0..RUNS).map(of).sum::<f64>() / f64::from(RUNS);
    let known = mean(&|run| closed_form(run)[0]);
    let found = mean(&|run| rows[run as usize][0]);
    assert!((found - known).abs() < 1e-9);
}
