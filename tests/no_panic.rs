//! Runs the proof, and checks that it can fail.

use std::path::Path;
use std::process::{Command, Output};

/// Links a program, all of it optimized as a whole: only then is known what can panic. The compiler of
/// descriptions is that of other optimized programs, since no setting of the profile concerns it.
fn link(program: &str) -> Output {
    Command::new(env!("CARGO"))
        .env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "1")
        .env("RUSTFLAGS", "-C embed-bitcode=yes")
        .args(["rustc", "--quiet", "--release", "--target", &host()])
        .args(["-p", "newton-euler-no-panic", "--features", "proof"])
        .args(["--bin", program, "--", "-C", "lto=fat"])
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .output()
        .expect("cargo runs")
}

/// This machine, as rustc calls it.
fn host() -> String {
    let of = Command::new("rustc").arg("-vV").output();
    let told = String::from_utf8(of.expect("rustc runs").stdout).expect("a text");
    let mut lines = told.lines();
    let host = lines.find_map(|line| line.strip_prefix("host: "));
    host.expect("a host").to_owned()
}

/// Asks a linked program how many functions it has.
fn run(program: &str) -> Output {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .parent()
        .expect("a folder");
    Command::new(target.join(host()).join("release").join(program))
        .output()
        .expect("the program runs")
}

#[test]
fn nothing_can_panic() {
    let Output { status, stderr, .. } = link("newton-euler-no-panic");
    assert!(status.success(), "{}", String::from_utf8_lossy(&stderr));
    let stdout = run("newton-euler-no-panic").stdout;
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
