//! No `unsafe` in either crate, not even with lints off. `tests/user_lints` checks generated code.

#[test]
fn both_crates_forbid_it() {
    for root in [
        include_str!("../macros/src/lib.rs"),
        include_str!("../runtime/src/lib.rs"),
    ] {
        assert!(root.lines().any(|line| line == "#![forbid(unsafe_code)]"));
    }
    let manifest = include_str!("../Cargo.toml");
    assert!(
        manifest
            .lines()
            .any(|line| line == r#"unsafe_code = "forbid""#)
    );
}
