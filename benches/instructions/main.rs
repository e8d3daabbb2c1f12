//! The instructions of one `acceleration` of each body in `examples/`, counted by callgrind.
//!
//! The counts repeat exactly. They may be 5 % above those in `counts.txt`; `BLESS=1` rewrites that
//! file. The counts belong to the toolchain of `rust-toolchain.toml` and to baseline x86-64, so
//! build without flags. Valgrind is required. Run `cargo bench --bench instructions`;
//! `tests/instructions.rs` runs it, too.

mod bodies;
mod counted;
mod record;
mod somewhere;

use bodies::BODIES;
use record::Record;

fn main() {
    let asked = std::env::args().nth(1).unwrap_or_default();
    if let Some(body) = BODIES.iter().find(|body| body.name == asked) {
        // this process runs in valgrind
        return (body.evaluate)();
    }
    let missing = bodies::missing();
    assert!(
        missing.is_empty(),
        "no body of the examples {missing:?} is counted"
    );
    let counts = BODIES
        .iter()
        .map(|body| (body.name, counted::count(body.name)));
    let measured: Record = counts.collect();
    if std::env::var_os("BLESS").is_some() {
        measured.write();
    }
    let faults = measured.compare(&Record::read());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
