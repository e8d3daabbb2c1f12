//! Invalid descriptions, and the errors that a user sees: one mistake per file, in folders named
//! after the kind of mistake, and `many/ten_mistakes.rs` with ten at once.
//!
//! The compiler runs here as a library, which takes seconds. Cases with other code in them are in
//! `rustc/`, and `rustc.rs` compiles them. After a change of wording, run
//! `BLESS=1 cargo test -p mounted --test messages` and review the difference.

mod rendered;

use std::fs;
use std::path::{Path, PathBuf};
use std::thread;

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../compile_fail"))
}

/// The files of all folders with this extension, from the folder of this package.
fn files(extension: &str) -> Vec<PathBuf> {
    let inside = fs::read_dir(root()).expect("the folder of cases is there");
    let folders = inside.map(|entry| entry.unwrap().path());
    let folders = folders.filter(|path| path.is_dir());
    let files = folders.flat_map(|folder| fs::read_dir(folder).unwrap());
    let files = files.map(|file| {
        file.unwrap()
            .path()
            .strip_prefix(root())
            .unwrap()
            .to_owned()
    });
    let mut files: Vec<PathBuf> = files
        .filter(|path| path.extension().is_some_and(|end| end == extension))
        .collect();
    files.sort();
    files
}

/// Compares all reports but those of rustc.
fn compare() {
    let overwrite = std::env::var_os("BLESS").is_some();
    let mut different = Vec::new();
    let cases = files("rs");
    for case in cases.iter().filter(|case| !case.starts_with("rustc")) {
        let source = fs::read_to_string(root().join(case)).unwrap();
        let report = rendered::report(&case.to_string_lossy(), &source);
        let report = report.unwrap_or_else(|| panic!("{}: its folder is `rustc`", case.display()));
        let expected = root().join(case).with_extension("stderr");
        let is_expected = fs::read_to_string(&expected).is_ok_and(|text| text == report);
        match (is_expected, overwrite) {
            (true, _) => {}
            (false, true) => fs::write(expected, report).unwrap(),
            (false, false) => different.push(report),
        }
    }
    let different = different.join("\n");
    assert!(different.is_empty(), "not as expected:\n\n{different}");
}

#[test]
fn wrong_descriptions_are_refused_in_these_words() {
    // as much stack as rustc has
    let thread = thread::Builder::new().stack_size(8 << 20);
    let compared = thread.spawn(compare).unwrap().join();
    compared.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
}

/// What is reported about each case.
fn reports() -> Vec<(PathBuf, String)> {
    let paths = files("stderr").into_iter();
    paths
        .map(|path| (path.clone(), fs::read_to_string(root().join(path)).unwrap()))
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
