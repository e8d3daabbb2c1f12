//! Time against error: every method of this library and its alternatives, on the same problems.
//!
//! Times are medians on one core, over rounds in which all methods are timed in turn. The error is
//! that of the end state, compared with more digits than a double has. The program prints a table
//! and writes it under `target/measures` as `work_precision.csv` and `.svg`:
//!
//! ```sh
//! cargo run --release --example work_precision                  # a few seconds
//! cargo run --release --example work_precision -- --full        # a few minutes: smaller errors, more bodies, more rounds
//! cargo run --release --example work_precision -- --full --systems     # systems of bodies alone
//! cargo run --release --example work_precision -- --full --ensembles   # ensembles alone
//! cargo run --release --example work_precision -- --full target/measures/peers.csv
//! ```
//!
//! The last one reads the measurements of `benches/peers/work_precision.py`. Each method
//! (`ours.rs`, `peers/`) and each problem (`bodies.rs`, `by_hand.rs`, `systems/`; their ends are
//! those of `tests/reference`) is one file.

mod bodies;
mod by_hand;
#[path = "../../benches/measure/chart.rs"]
mod chart;
#[path = "../../benches/measure/clock.rs"]
mod clock;
mod diagram;
mod distance;
#[path = "../../benches/measure/drawing.rs"]
mod drawing;
mod ensemble;
#[path = "../../benches/measure/folder.rs"]
mod folder;
mod measure;
mod method;
mod ours;
mod peers;
mod problem;
mod problems;
#[path = "../../tests/reference/mod.rs"]
mod reference;
mod systems;
mod table;

use std::error::Error;
use std::time::Duration;
use std::{env, fs};

use measure::Care;
use table::Table;

const QUICK: Care = Care {
    rounds: 5,
    shortest: 50e-6,
    longest: Duration::from_millis(5),
};

const FULL: Care = Care {
    rounds: 31,
    shortest: 200e-6,
    longest: Duration::from_millis(30),
};

/// For a thousand bodies.
const MANY: Care = Care {
    rounds: 11,
    shortest: 200e-6,
    longest: Duration::from_millis(300),
};

fn main() -> Result<(), Box<dyn Error>> {
    let (flags, files): (Vec<String>, Vec<String>) =
        env::args().skip(1).partition(|word| word.starts_with("--"));
    let [mut is_full, mut only_systems, mut only_ensembles] = [false; 3];
    for flag in &flags {
        match flag.as_str() {
            "--full" => is_full = true,
            "--systems" => only_systems = true,
            "--ensembles" => only_ensembles = true,
            _ => {
                let known = "--full, --systems, --ensembles";
                return Err(format!("only {known} and files, not {flag}").into());
            }
        }
    }
    let care = if is_full { FULL } else { QUICK };

    let mut curves = Vec::new();
    if !only_ensembles {
        curves.extend(systems::all(care));
    }
    if !only_systems && !only_ensembles {
        curves.extend(problems::all(care));
    }
    if !only_systems {
        curves.extend(ensemble::tops(care, 8));
        if is_full {
            curves.extend(ensemble::tops(MANY, 1024));
        }
    }
    for file in files {
        curves.extend(table::read(&fs::read_to_string(file)?)?);
    }
    println!("{}", Table(&curves));

    // target/release/examples/work_precision
    let program = env::current_exe()?;
    let target = program.ancestors().nth(3).ok_or("not run by cargo")?;
    folder::keep(
        target,
        &[
            ("work_precision.csv", table::csv(&curves)),
            ("work_precision.svg", diagram::diagram(&curves)),
        ],
    )?;
    Ok(())
}
