//! The dependencies of a user's build: their number, sources, licenses and Rust versions.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;

use serde_json::Value;

/// What cargo prints, asked in this workspace.
fn cargo(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO"))
        .args(arguments)
        .args(["--locked", "--manifest-path"])
        .arg(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml"))
        .output()
        .expect("cargo is there");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    String::from_utf8(output.stdout).expect("text")
}

/// The crates that a dependency on newton-euler with some features brings into a build: name, version and source.
fn pulled_in(features: &[&str]) -> BTreeSet<String> {
    let tree = "tree --package newton-euler --edges normal,build --prefix none --format {p}";
    let arguments: Vec<&str> = tree.split(' ').chain(features.iter().copied()).collect();
    let lines = cargo(&arguments);
    let crates = lines.lines().map(|line| line.trim_end_matches(" (*)"));
    let crates = crates.map(|line| line.trim_end_matches(" (proc-macro)").to_owned());
    crates.filter(|line| !line.is_empty()).collect()
}

fn name(package: &str) -> &str {
    package.split(' ').next().unwrap_or(package)
}

const NONE: &[&str] = &["--no-default-features"];
const ALL: &[&str] = &["--all-features"];

#[test]
fn a_build_pulls_in_little() {
    // with the two of ours; what each feature adds is in the crates it is for
    for (features, most) in [(NONE, 25), (&[][..], 33), (ALL, 55)] {
        let crates = pulled_in(features);
        assert!(
            crates.len() <= most,
            "{features:?}: {} crates\n{crates:#?}",
            crates.len()
        );
    }
}

#[test]
fn every_crate_is_there_once() {
    let mut versions = BTreeMap::<String, Vec<String>>::new();
    for package in pulled_in(ALL) {
        versions
            .entry(name(&package).to_owned())
            .or_default()
            .push(package);
    }
    let twice: Vec<_> = versions.values().filter(|all| all.len() > 1).collect();
    assert!(twice.is_empty(), "{twice:#?}");
}

/// All packages of the workspace's lock, with what their manifests say.
fn manifests() -> Vec<Value> {
    let metadata = cargo(&["metadata", "--format-version", "1"]);
    let metadata: Value = serde_json::from_str(&metadata).expect("JSON");
    metadata["packages"].as_array().expect("a list").clone()
}

/// Whether a license expression lets everyone use the crate, given these licenses.
fn is_permitted(license: &str) -> bool {
    const PERMITTED: [&str; 4] = ["MIT", "Apache-2.0", "Zlib", "Unicode-3.0"];
    let license = license.replace('/', " OR ").replace(['(', ')'], "");
    license.split(" AND ").all(|needed| {
        needed
            .split(" OR ")
            .any(|one| PERMITTED.contains(&one.trim()))
    })
}

#[test]
fn licenses_are_permissive() {
    assert!(is_permitted("(MIT OR GPL-3.0) AND Unicode-3.0") && !is_permitted("MIT AND GPL-3.0"));
    for package in manifests() {
        let (name, license) = (&package["name"], package["license"].as_str());
        assert!(license.is_some_and(is_permitted), "{name}: {license:?}");
    }
}

#[test]
fn crates_come_from_the_registry() {
    for package in manifests() {
        let (name, source) = (&package["name"], package["source"].as_str());
        let is_ours = package["manifest_path"]
            .as_str()
            .is_some_and(|path| path.starts_with(env!("CARGO_MANIFEST_DIR")));
        let is_registered = source.is_some_and(|source| source.starts_with("registry+"));
        assert!(is_ours || is_registered, "{name}: {source:?}");
    }
}

/// Nothing that a user builds asks for a newer Rust than we say.
#[test]
fn no_crate_asks_for_a_newer_rust() {
    let of = |version: &str| -> Vec<u32> {
        let parts = version
            .split('.')
            .map(|part| part.parse().expect("a number"));
        parts.take(2).collect()
    };
    let crates = pulled_in(ALL);
    let ours = of(env!("CARGO_PKG_RUST_VERSION"));
    for package in manifests() {
        let text = |key: &str| package[key].as_str().unwrap_or_default();
        let known_as = format!("{} v{}", text("name"), text("version"));
        let is_built = crates.iter().any(|other| other.starts_with(&known_as));
        if let (true, Some(version)) = (is_built, package["rust_version"].as_str()) {
            assert!(of(version) <= ours, "{known_as} asks for Rust {version}");
        }
    }
}
