//! Tells the crate whether it is compiled without optimization.
//!
//! Code that runs in lanes is inlined, so that it is compiled for the register. Without
//! optimization this gains nothing, and rustc takes ten times as long.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(unoptimized)");
    // of editors
    println!("cargo::rustc-check-cfg=cfg(rust_analyzer)");
    if std::env::var("OPT_LEVEL").is_ok_and(|level| level == "0") {
        println!("cargo::rustc-cfg=unoptimized");
    }
}
