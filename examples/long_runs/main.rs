//! Long runs: the drift of energy, angular momentum and attitude over a hundred million steps, and
//! a satellite's week.
//!
//! Each method integrates each body from four starts in steps of equal length. Errors are recorded
//! after 2, 4, 8, ... steps, and the law of their growth, error = a nᵖ after n steps, is fitted.
//! Rounding that is summed with compensation is a random walk, p = ½. What a method loses in every
//! step grows with n, p = 1. An angle, which accumulates the error of the rate, has one power more.
//! The program prints a table and writes it under `target/measures` as `long_runs.csv` and
//! `long_runs.svg`:
//!
//! ```sh
//! cargo run --release --example long_runs                  # a few seconds: 2¹⁷ steps
//! cargo run --release --example long_runs -- 22            # 2²² steps
//! cargo run --release --example long_runs -- --full        # a quarter of an hour: 2²⁷ = 1.3e8 steps
//! ```
//!
//! Asserts: the exponents agree with the expected ones; energy and momentum of the series are
//! within 1e-13 after 2²² steps.

mod bodies;
#[path = "../../benches/measure/chart.rs"]
mod chart;
#[path = "../../benches/measure/drawing.rs"]
mod drawing;
#[path = "../../benches/measure/folder.rs"]
mod folder;
mod growth;
mod march;
mod problem;
#[path = "../../tests/reference/mod.rs"]
mod reference;
mod report;
mod week;

use std::env;
use std::error::Error;

use bodies::{FreeBody, HeavyTop, LagrangeTop};
use nalgebra::Vector3;
use newton_euler::prelude::*;

use growth::{Growth, follow};
use problem::Problem;
use report::Table;

/// All methods on a problem, with their results.
fn all<B>(problem: &Problem<'_, B>, doublings: u32) -> Vec<Growth>
where
    B: Taylor<State = Rotation, Input = ()> + Energy + Momentum<Angular = Vector3<f64>>,
{
    let ways = march::all();
    let results: Vec<Growth> = ways
        .iter()
        .map(|way| follow(problem, way, doublings))
        .collect();
    println!("{}", Table(&results));
    results
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = env::args().skip(1).collect();
    let doublings = match words.as_slice() {
        [] => Some(17),
        [word] if word == "--full" => Some(27),
        [word] => word.parse().ok().filter(|doublings| *doublings < 40),
        _ => None,
    };
    let doublings = doublings.ok_or("only --full or a number below 40 is understood")?;

    let free = FreeBody::default();
    let (lagrange, heavy) = (LagrangeTop::default(), HeavyTop::default());
    println!("error at the end, and p of error = a nᵖ as fitted (and expected)\n");
    let mut results = all(&problem::free(&free), doublings);
    results.extend(all(&problem::lagrange(&lagrange), doublings));
    results.extend(all(&problem::heavy(&heavy), doublings));
    week::print()?;

    // target/release/examples/long_runs
    let program = env::current_exe()?;
    let target = program.ancestors().nth(3).ok_or("not run by cargo")?;
    folder::keep(
        target,
        &[
            ("long_runs.csv", report::csv(&results)),
            ("long_runs.svg", report::picture(&results)),
        ],
    )?;
    Ok(())
}
