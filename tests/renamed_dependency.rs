//! A user's crate that renames the dependency, and one that gets it through a third crate.
//!
//! The sources are in `renamed/`. The manifests are written here, because the paths in them are
//! absolute. Both are built offline from the dependencies of this workspace, in the versions of its
//! lock file.

use std::fs;
use std::path::Path;
use std::process::Command;

const USER: &str = r#"[package]
name = "user"
edition = "2024"

[[bin]]
name = "user"
path = "SOURCES/user.rs"

[dependencies]
dynamics = { package = "newton-euler", path = "RUNTIME" }
facade = { path = "facade" }

[workspace]
members = ["facade"]
"#;

const FACADE: &str = r#"[package]
name = "facade"
edition = "2024"

[lib]
path = "SOURCES/facade.rs"

[dependencies]
dynamics_underneath = { package = "newton-euler", path = "RUNTIME" }
"#;

#[test]
fn a_users_crate_may_call_the_library_as_it_likes() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("renamed");
    fs::create_dir_all(folder.join("facade")).unwrap();
    let write = |place: &str, manifest: &str| {
        let path = |inner: &str| root.join(inner).to_str().unwrap().replace('\\', "/");
        let manifest = manifest
            .replace("SOURCES", &path("tests/renamed"))
            .replace("RUNTIME", &path("runtime"));
        fs::write(folder.join(place), manifest).unwrap();
    };
    write("Cargo.toml", USER);
    write("facade/Cargo.toml", FACADE);
    fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();

    let run = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--offline", "--target-dir"])
        .arg(folder.join("target"))
        .current_dir(&folder)
        .output()
        .unwrap();
    let [out, errors] = [run.stdout, run.stderr].map(|text| String::from_utf8(text).unwrap());
    assert!(run.status.success(), "{errors}");
    // -g; 3 N on 2 kg; 3 N at 0.25 m on 0.5 kg m²; nothing
    assert_eq!(out.trim(), "-9.8 1.5 1.5 0");
}
