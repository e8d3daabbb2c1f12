//! Draws the bodies and writes them for the compiler: `BODIES` of them from index `FIRST` on, and
//! `MOVING` bodies whose motions are integrated, from the seed `SEED`.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::{env, fs};

mod answer;
#[allow(dead_code, reason = "the oracle asks for more than the writer")]
#[path = "../src/description/mod.rs"]
mod description;
mod march;
#[allow(dead_code, reason = "the oracle computes with what literals hold here")]
#[path = "../src/wide/mod.rs"]
mod wide;

/// Bodies of an ordinary test run, and those that are moved.
const FEW: u64 = 24;
const FEW_MOVING: u64 = 16;

fn main() {
    let [count, first, seed, moving] = [
        ("BODIES", FEW),
        ("FIRST", 0),
        ("SEED", 1),
        ("MOVING", FEW_MOVING),
    ]
    .map(|(name, otherwise)| {
        println!("cargo::rerun-if-env-changed={name}");
        env::var(name).map_or(otherwise, |text| text.parse().expect("a whole number"))
    });
    println!("cargo::rerun-if-changed=build");
    println!("cargo::rerun-if-changed=src/description");
    println!("cargo::rerun-if-changed=src/wide");
    let indices = first..first + count;
    let mut text = String::new();
    let mut table = String::new();
    for index in indices {
        let index = usize::try_from(index).expect("a number of bodies");
        let body = description::draw::body(seed, index);
        text.push_str(&answer::module(&body, index));
        let _ = writeln!(table, "    ({index}, body_{index}::answer),");
    }
    let _ = write!(
        text,
        "/// The seed of these bodies.\npub const SEED: u64 = {seed};\n\
         /// Each body by its index.\npub const ALL: &[(usize, fn(&Given, &mut Answers))] = &[\n{table}];\n"
    );
    let mut table = String::new();
    for index in first..first + moving {
        let index = usize::try_from(index).expect("a number of bodies");
        let body = description::moving::moving_body(seed, index);
        text.push_str(&march::module(&body, index));
        let _ = writeln!(table, "    ({index}, moving_{index}::march),");
    }
    let _ = write!(
        text,
        "/// Each body that is moved by its index.\npub const MOVING: &[(usize, March)] = &[\n{table}];\n"
    );
    let folder = PathBuf::from(env::var_os("OUT_DIR").expect("cargo says where"));
    fs::write(folder.join("bodies.rs"), text).expect("the folder can be written to");
}
