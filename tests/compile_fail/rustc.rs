//! Invalid descriptions as rustc compiles them: those of `rustc/` with code beside them, and some that
//! show that it prints what `messages.rs` expects.
//!
//! What rustc adds depends on the toolchain, which `rust-toolchain.toml` pins. After a change of
//! wording, run `TRYBUILD=overwrite cargo test -p compile-fail` and review the difference.

#[test]
fn rustc_refuses_in_these_words() {
    let cases = trybuild::TestCases::new();
    cases.compile_fail("rustc/*.rs");
    cases.compile_fail("many/*.rs");
}
