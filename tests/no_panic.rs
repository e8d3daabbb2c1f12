//! Runs the proof, and checks that it can fail.

use std::process::{Command, Output};

/// Links a program, and asks it how many functions it has. What can panic is known only when all is
/// optimized as a whole.
fn link(program: &str) -> Output {
    Command::new(env!("CARGO"))
        .env("CARGO_PROFILE_RELEASE_LTO", "fat")
        .env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "1")
        .args(["run", "--quiet", "--release"])
        .args(["-p", "newton-euler-no-panic", "--features", "proof"])
        .args(["--bin", program])
        .env_remove("RUSTFLAGS")
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .output()
        .expect("cargo runs")
}

#[test]
fn nothing_can_panic() {
    let Output {
        status,
        stdout,
        stderr,
    } = link("newton-euler-no-panic");
    assert!(status.success(), "{}", String::from_utf8_lossy(&stderr));
    let text = String::from_utf8_lossy(&stdout);
    println!("proven: {text}");
    let count = text
        .split_whitespace()
        .next()
        .and_then(|word| word.parse().ok());
    assert!(count.is_some_and(|count: u32| count > 300), "{text}");
}

#[test]
fn what_can_panic_does_not_link() {
    let Output { status, stderr, .. } = link("newton-euler-broken");
    let message = String::from_utf8_lossy(&stderr);
    assert!(!status.success(), "it links");
    assert!(
        message.contains("detected panic in function `broken`"),
        "{message}"
    );
}
