//! No `unsafe`, in either crate: not even where a lint is switched off. Generated code is held to it in `tests/user_lints`.

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
