//! One `acceleration` of each example takes at most 5 % more instructions than recorded.
//!
//! The counts are for optimized code, so this runs `benches/instructions`, built without flags. It
//! does not use the test harness, which would not show that the test is skipped.

use std::process::Command;

fn main() {
    if !cfg!(all(target_arch = "x86_64", target_os = "linux")) {
        println!("instructions: SKIPPED, the counts on record are those of x86-64 Linux");
        return;
    }
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("instructions: SKIPPED, valgrind is not installed");
        return;
    }
    let counted = Command::new(env!("CARGO"))
        .args(["bench", "--quiet", "--offline", "--bench", "instructions"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .env_remove("BLESS")
        .env_remove("RUSTFLAGS")
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .status()
        .expect("cargo runs");
    assert!(counted.success(), "see above");
}
