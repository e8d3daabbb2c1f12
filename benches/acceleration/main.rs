//! What generated accelerations cost, against hand-written nalgebra for the same bodies.
//!
//! Both sides are checked against each other and then timed in turn, in one thread of one run. A table is printed, and written
//! under `target/measures` as `acceleration.csv` and `acceleration.svg`. `cargo bench --bench acceleration`

mod bodies;
mod by_hand;
mod ensemble;
mod memory;
mod one_by_one;
mod pair;
mod paired;
mod picture;
mod table;

use std::path::Path;
use std::{fs, io};

use table::Table;

fn main() -> io::Result<()> {
    let mut table = Table::default();
    one_by_one::measure(&mut table);
    ensemble::measure(&mut table);
    println!("{table}");

    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("measures");
    fs::create_dir_all(&folder)?;
    for (name, text) in [
        ("acceleration.csv", table.csv()),
        ("acceleration.svg", picture::bars(&table)),
    ] {
        fs::write(folder.join(name), text)?;
        println!("{}", folder.join(name).display());
    }
    Ok(())
}
