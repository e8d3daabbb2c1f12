//! Invalid descriptions, and the errors that a user sees: one mistake per file, in folders named
//! after the kind of mistake, and `many/ten_mistakes.rs` with ten at once.
//!
//! The messages depend on the toolchain, which `rust-toolchain.toml` pins. After a change of
//! wording, run `TRYBUILD=overwrite cargo test -p compile-fail` and review the difference.

use std::fs;
use std::path::{Path, PathBuf};

/// Files that cases name are read from the folder of the crate that they are compiled in.
fn hand_over_files() {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().unwrap();
    let to = target.join("tests/trybuild").join(env!("CARGO_PKG_NAME"));
    fs::create_dir_all(&to).unwrap();
    let cases = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders =
        ["urdf", "mjcf", "tables"].map(|folder| fs::read_dir(cases.join(folder)).unwrap());
    for file in folders.into_iter().flatten() {
        let file = file.unwrap().path();
        if file
            .extension()
            .is_some_and(|end| end == "urdf" || end == "xml" || end == "csv")
        {
            fs::copy(&file, to.join(file.file_name().unwrap())).unwrap();
        }
    }
}

#[test]
fn wrong_descriptions_are_refused_in_these_words() {
    hand_over_files();
    trybuild::TestCases::new().compile_fail("*/*.rs");
}

/// What rustc prints about each case.
fn reports() -> Vec<(PathBuf, String)> {
    let root = env!("CARGO_MANIFEST_DIR");
    let inside = fs::read_dir(root).expect("the folder of cases is there");
    let paths = inside.map(|entry| entry.unwrap().path());
    let folders = paths.filter(|path| path.is_dir());
    let files = folders.flat_map(|folder| fs::read_dir(folder).unwrap());
    let paths = files.map(|file| file.unwrap().path());
    let reports = paths.filter(|path| path.extension().is_some_and(|end| end == "stderr"));
    reports
        .map(|path| (path.clone(), fs::read_to_string(path).unwrap()))
        .collect()
}

#[test]
fn messages_are_lower_case_and_know_no_path() {
    let reports = reports();
    assert!(reports.len() >= 40);
    for (path, report) in reports {
        let path = path.display();
        let is_place = |line: &str| line.trim_start().starts_with("--> ");
        let mut said = report.lines().filter(|line| !is_place(line));
        assert!(
            said.all(|line| !line.contains("$WORKSPACE")),
            "{path} names a path"
        );
        assert!(!report.contains("panicked"), "{path}: the macro panicked");
        for message in report
            .lines()
            .filter_map(|line| line.strip_prefix("error: "))
        {
            let first = message.chars().next();
            assert!(!first.is_some_and(char::is_uppercase), "{path}: {message}");
            assert!(!message.ends_with('.'), "{path}: {message}");
        }
    }
}

#[test]
fn ten_mistakes_are_ten_errors() {
    let all = reports();
    let (_, report) = all
        .iter()
        .find(|(path, _)| path.ends_with("many/ten_mistakes.stderr"))
        .expect("the case is there");
    let errors = report.lines().filter(|line| line.starts_with("error"));
    assert_eq!(errors.count(), 10, "{report}");
}

/// The page of the guide quotes messages in these words.
#[test]
fn documented_errors_are_reported() {
    let page = include_str!("../../runtime/src/guide/errors.md");
    let all = reports();
    let quoted = page.lines().filter(|line| line.starts_with("error"));
    let stale: Vec<&str> = quoted
        .clone()
        .filter(|quote| {
            !all.iter()
                .any(|(_, report)| report.lines().any(|line| line == *quote))
        })
        .collect();
    assert!(quoted.count() >= 40);
    assert!(stale.is_empty(), "no case reports: {stale:#?}");
}
