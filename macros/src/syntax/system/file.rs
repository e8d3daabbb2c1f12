//! `urdf: "robot.urdf"`: the content of a file, combined with the written description.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use proc_macro2::{Ident, Span, TokenTree};

use crate::errors::{Errors, Extent};
use crate::syntax::entries::key_value;
use crate::syntax::mjcf;
use crate::syntax::tokens::{stream, string};
use crate::syntax::urdf;
use crate::syntax::xml::{Beside, Told};
use crate::syntax::{Description, Written};

use super::System;

/// The format of a file.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    Urdf,
    Mjcf,
}

/// The keys that name a file.
pub(super) const KEYS: [&str; 2] = ["urdf", "mjcf"];

/// The file named by a description.
pub struct File {
    /// The path as written.
    name: String,
    span: Span,
    format: Format,
    /// The path of the file on this machine, if it was read: when the file changes, the description
    /// is expanded again.
    pub path: Option<String>,
    pub told: Told,
}

impl System {
    /// `urdf: "robot.urdf"` or `mjcf: "model.xml"`
    pub(super) fn parse_file(&mut self, key: &Ident, rest: &[TokenTree], errors: &mut Errors) {
        self.lost.bodies = true;
        self.lost.joints = true;
        let value = key_value(key, rest, errors);
        if value.is_empty() {
            return;
        }
        let Some(text) = string(value) else {
            let message = format!(
                "expected the path of a file in a string: `{key}: \"robot.{}\"`",
                if key == KEYS[0] { "urdf" } else { "xml" }
            );
            errors.push(Extent::of(stream(value)), message);
            return;
        };
        self.file = Some(File {
            name: text.value(),
            span: text.span(),
            format: if key == KEYS[0] {
                Format::Urdf
            } else {
                Format::Mjcf
            },
            path: None,
            told: Told::default(),
        });
        self.lost.bodies = false;
        self.lost.joints = false;
    }

    /// Adds the bodies and joints of the file, if there is one.
    pub(super) fn read_file(&mut self, errors: &mut Errors) {
        let Some(mut file) = self.file.take() else {
            let mut locked = self.locked.iter().filter(|locked| locked.value.is_some());
            if let Some(first) = locked.next().filter(|_| !self.lost.joints) {
                let message = "`locked` holds joints of a file, and there is no `urdf: \"..\"` or `mjcf: \"..\"`";
                errors.push(first.name.span(), message);
            }
            let is_named = |key: &Ident| KEYS.iter().any(|word| key == word);
            if self.top.keys.iter().any(is_named) {
                self.lose_substances();
            }
            return;
        };
        let before = errors.count();
        let added = self.add_file(&mut file, errors);
        if added.is_none() {
            self.lose_substances();
        }
        if added.is_none() || errors.count() > before {
            self.lost.bodies = true;
            self.lost.joints = true;
        }
        self.file = Some(file);
    }

    /// If the file is not read, the mass and inertia that a body lacks may be in it.
    fn lose_substances(&mut self) {
        for body in &mut self.bodies {
            for written in [&mut body.mass, &mut body.inertia] {
                written.get_or_insert(Written { value: None });
            }
        }
    }

    fn add_file(&mut self, file: &mut File, errors: &mut Errors) -> Option<()> {
        let File {
            name, span, format, ..
        } = &*file;
        if let Some(motion) = &self.top.motion {
            let message = "a file describes a system in space: leave `motion` out";
            return errors.report(motion.word.span(), message);
        }
        if self.is_drawn() {
            let mut keys = self.top.keys.iter();
            let key = keys.find(|key| *key == "drawing");
            let message = "a file describes each body in its own axes, and so do the bodies and joints next to it: leave `drawing` out";
            return errors.report(key.map_or(*span, Ident::span), message);
        }
        let (path, text) = file_beside(name, *span, errors)?;
        let beside = Beside {
            runtime: &self.top.runtime,
            bodies: &self.bodies,
            joints: &self.joints,
            locked: &self.locked,
            fields: &self.top.loads,
        };
        let described = match format {
            Format::Urdf => urdf::read((name, *span), &text, beside, errors),
            Format::Mjcf => mjcf::read((name, *span), &text, beside, errors),
        };
        file.path = path;
        let described = described?;
        file.told = described.told;
        let written = core::mem::replace(&mut self.joints, described.joints);
        self.joints.extend(written);
        self.top.inputs.splice(0..0, described.inputs);
        self.top.loads.splice(0..0, described.fields);
        self.top.potentials.splice(0..0, described.potentials);
        self.drives.splice(0..0, described.drives);
        self.top.constraints.splice(0..0, described.constraints);
        for body in described.bodies {
            self.add_link(body, errors);
        }
        Some(())
    }

    /// Adds a body, or merges the file's body into the written one.
    fn add_link(&mut self, mut body: Description, errors: &mut Errors) {
        let Some(written) = self.bodies.iter_mut().find(|other| other.name == body.name) else {
            self.firsts.push(self.bodies.len());
            self.bodies.push(body);
            return;
        };
        if let Some(key) = written.keys.iter().find(|_| written.composition.is_some()) {
            let name = &body.name;
            errors.push(
                written.keys.iter().find(|key| *key == "inertia").unwrap_or(key).span(),
                format!("the file says where G of `{name}` is: write its inertia about that, or a body of another name, and weld it"),
            );
            written.composition = None;
        }
        if body.composition.is_some() {
            let given = written
                .keys
                .iter()
                .find(|key| *key == "mass" || *key == "inertia");
            if let Some(key) = given {
                let message = "the file says what this body is made of: leave it out, or weld another body to it";
                errors.push(key.span(), message);
            }
            written.composition = body.composition.take();
        }
        // written values replace those of the file
        let is_told = written.mass.is_some() || written.inertia.is_some();
        written.is_frame = body.is_frame && !is_told;
        written.mass = written.mass.take().or(body.mass);
        written.inertia = written.inertia.take().or(body.inertia);
        written.given = body.given;
        let own = core::mem::take(&mut written.points);
        written.points = core::mem::take(&mut body.points);
        written.points.extend(own);
    }
}

/// The file with this name, relative to the folder of `Cargo.toml`: its path on this machine, and
/// its text.
pub fn file_beside(
    name: &str,
    place: impl Into<Extent>,
    errors: &mut Errors,
) -> Option<(Option<String>, String)> {
    // cargo sets this to the folder of the crate that is compiled
    let folder = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default();
    let path = PathBuf::from(folder).join(name);
    match read(&path) {
        Ok(text) => Some((path.to_str().map(str::to_owned), text)),
        Err(why) => {
            let message = format!(
                "`{name}` is looked for from the folder of the `Cargo.toml` of this crate, and {why}"
            );
            errors.report(place, message)
        }
    }
}

fn read(path: &Path) -> Result<String, String> {
    let bytes = std::fs::read(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => "there is no such file".to_owned(),
        kind => format!("cannot be read: {kind}"),
    })?;
    String::from_utf8(bytes).map_err(|_| "is no text in UTF-8".to_owned())
}
