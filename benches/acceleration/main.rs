//! The cost of generated accelerations, compared with hand-written nalgebra for the same bodies.
//!
//! Both sides are checked against each other, and then timed alternately, in one thread of one run.
//! The program prints a table, and writes `acceleration.csv` and `acceleration.svg` to
//! `target/measures`. Run `cargo bench --bench acceleration`.

mod bodies;
mod by_hand;
#[path = "../measure/clock.rs"]
mod clock;
mod derivatives;
#[path = "../measure/drawing.rs"]
mod drawing;
mod ensemble;
#[path = "../measure/folder.rs"]
mod folder;
mod memory;
mod one_by_one;
mod pair;
mod paired;
mod picture;
mod table;

use std::io;
use std::path::Path;

use table::Table;

fn main() -> io::Result<()> {
    let mut table = Table::default();
    one_by_one::measure(&mut table);
    derivatives::measure(&mut table);
    ensemble::measure(&mut table);
    println!("{table}");

    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent();
    folder::keep(
        target.expect("a folder of the target"),
        &[
            ("acceleration.csv", table.csv()),
            ("acceleration.svg", picture::bars(&table)),
        ],
    )
}
