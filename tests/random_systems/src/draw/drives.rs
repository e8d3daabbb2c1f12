//! Random drives of joints.

use std::ops::Range;

use super::sizes::Turning;
use super::{DRIVES, Drawing};
use crate::law::kind::Kind;
use crate::law::scene::{Loads, Scene};
use crate::law::space::{Vec3, ZERO, apply, dot, transposed};
use crate::wide::Wide;

/// The coordinates of a joint that are one freedom each: how a drive names them, its unit, and which
/// of the freedoms.
fn coordinates(kind: Kind) -> &'static [(&'static str, &'static str, usize)] {
    match kind {
        Kind::Revolute(_) | Kind::Screw(..) => &[("", "N * m", 0)],
        Kind::Prismatic(_) => &[("", "N", 0)],
        Kind::Cylindrical(_) => &[(".position", "N", 0), (".angle", "N * m", 1)],
        Kind::Universal(..) => &[(".angle_1", "N * m", 0), (".angle_2", "N * m", 1)],
        Kind::Planar(..) | Kind::Plane => &[(".angle", "N * m", 2)],
        _ => &[],
    }
}

/// The coordinates that are vectors: their words, their units, whether they are in the axes of the
/// carried body, and their freedoms. The slides of a planar joint, with axes of their own, are left out.
fn vectors(kind: Kind) -> Vec<(&'static str, &'static str, bool, Range<usize>)> {
    match kind {
        Kind::Spherical => vec![("", "N * m", true, 0..3)],
        Kind::Free => vec![
            (".position", "N", false, 0..3),
            (".attitude", "N * m", true, 3..6),
        ],
        Kind::Plane => vec![(".position", "N", false, 0..2)],
        Kind::Shift(count) => vec![("", "N", false, 0..count)],
        _ => Vec::new(),
    }
}

/// Adds a load along a freedom: on a free body a force at its G or a moment, otherwise what the
/// joint transmits.
fn add(scene: &Scene<'_>, loads: &mut Loads, (joint, freedom): (usize, usize), load: Wide) {
    let along = |axis: usize| {
        let mut vector = ZERO;
        vector[axis] = load;
        vector
    };
    match (scene.links[joint].kind, freedom) {
        (Kind::Free, 0..3) | (Kind::Plane, 0..2) => {
            loads.force(scene, joint, ZERO, along(freedom));
        }
        (Kind::Free, _) => loads.moment(joint, scene.turned(Some(joint), along(freedom - 3))),
        (Kind::Plane, _) => loads.moment(joint, along(2)),
        _ => {
            let drive = &mut loads.drives[joint][freedom];
            *drive = *drive + load;
        }
    }
}

impl Drawing {
    pub fn drive(&mut self, joint: usize) {
        let kind = self.links[joint].kind;
        if self.links[joint].driven.is_some() {
            return;
        }
        match kind {
            Kind::Spherical => self.drive_ball(joint),
            Kind::Planar(..) => self.drive_slides(joint, ".position"),
            Kind::Shift(_) => self.drive_slides(joint, ""),
            Kind::Free | Kind::Plane => self.drive_free(joint),
            _ => {}
        }
        let all = coordinates(kind);
        for (word, unit, freedom) in all {
            if all.len() > 1 && self.numbers.one_of(3) {
                continue;
            }
            let (written, size) = self.size(unit);
            let is_kept = self.is_kept();
            if is_kept {
                self.tops[DRIVES]
                    .push(format!("d{joint}_{freedom} = {written}.on(j{joint}{word})"));
            }
            self.act(
                is_kept,
                Box::new(move |scene, loads| add(scene, loads, (joint, *freedom), size(scene))),
            );
        }
    }

    /// Inputs that drive each freedom, in the place of open drives.
    pub fn open_drives(&mut self, joint: usize) {
        let kind = self.links[joint].kind;
        let single = coordinates(kind).iter().map(|(.., freedom)| *freedom);
        let several = vectors(kind)
            .into_iter()
            .flat_map(|(.., freedoms)| freedoms);
        for freedom in single.chain(several) {
            // numbered when all other inputs are
            self.open.push((joint, freedom, usize::MAX));
        }
    }

    /// An input for an open drive along a freedom.
    fn open_input(&mut self, joint: usize, freedom: usize, unit: &str) -> String {
        let (name, place) = self.numbers.input(unit);
        let is_this = |open: &&mut (usize, usize, usize)| (open.0, open.1) == (joint, freedom);
        if let Some((.., number)) = self.open.iter_mut().find(is_this) {
            *number = place;
        }
        self.acting.push(Box::new(move |scene, loads| {
            add(scene, loads, (joint, freedom), scene.instant.inputs[place]);
        }));
        name
    }

    pub fn open_inputs(&mut self) {
        let mut joints: Vec<usize> = self.open.iter().map(|(joint, ..)| *joint).collect();
        joints.dedup();
        for joint in joints {
            let kind = self.links[joint].kind;
            for (word, unit, freedom) in coordinates(kind) {
                let input = self.open_input(joint, *freedom, unit);
                let drive = format!("o{joint}_{freedom} = {input}.on(j{joint}{word})");
                self.tops[DRIVES].push(drive);
            }
            for (word, unit, is_in_body, freedoms) in vectors(kind) {
                let first = freedoms.start;
                let inputs = freedoms.map(|freedom| self.open_input(joint, freedom, unit));
                let inputs: Vec<String> = inputs.collect();
                let axes = if is_in_body {
                    format!("{}.body", self.name(joint))
                } else {
                    "world".to_owned()
                };
                let parts = inputs.join(", ");
                let drive = format!("o{joint}_{first} = {axes}({parts}).on(j{joint}{word})");
                self.tops[DRIVES].push(drive);
            }
        }
    }

    /// The body that carries a joint, in words, with its axes.
    fn moment_words(&mut self, joint: usize, word: &str) -> String {
        // the body is not meant by itself outside of its braces
        word.replacen("body(", &format!("{}.body(", self.name(joint)), 1)
    }

    fn drive_ball(&mut self, joint: usize) {
        let (word, moment) = self.vector("N * m");
        let word = self.moment_words(joint, &word);
        let is_kept = self.is_kept();
        if is_kept {
            self.tops[DRIVES].push(format!("d{joint} = {word}.on(j{joint})"));
        }
        self.act(
            is_kept,
            Box::new(move |scene, loads| {
                let back = transposed(&scene.motions[joint].attitude);
                let along = apply(&back, moment(scene, joint));
                for (drive, part) in loads.drives[joint].iter_mut().zip(along) {
                    *drive = *drive + part;
                }
            }),
        );
    }

    /// A force at G and a moment, on a body that is free.
    fn drive_free(&mut self, joint: usize) {
        let force = self.vector("N");
        self.on_free(joint, ".position", force, move |scene, loads, force| {
            loads.force(scene, joint, ZERO, force);
        });
        if self.links[joint].kind == Kind::Free {
            let moment = self.vector("N * m");
            self.on_free(joint, ".attitude", moment, move |_, loads, moment| {
                loads.moment(joint, moment);
            });
        }
    }

    fn on_free(
        &mut self,
        joint: usize,
        coordinate: &str,
        (word, vector): (String, Turning),
        adds: impl Fn(&Scene<'_>, &mut Loads, Vec3) + 'static,
    ) {
        let word = self.moment_words(joint, &word);
        let is_kept = self.is_kept();
        if is_kept {
            let number = self.tops[DRIVES].len();
            let drive = format!("t{joint}_{number} = {word}.on(j{joint}{coordinate})");
            self.tops[DRIVES].push(drive);
        }
        self.act(
            is_kept,
            Box::new(move |scene, loads| adds(scene, loads, vector(scene, joint))),
        );
    }

    /// A force along slides.
    fn drive_slides(&mut self, joint: usize, coordinate: &str) {
        let (word, force) = self.vector("N");
        let word = self.moment_words(joint, &word);
        let is_kept = self.is_kept();
        if is_kept {
            let drive = format!("t{joint} = {word}.on(j{joint}{coordinate})");
            self.tops[DRIVES].push(drive);
        }
        self.act(
            is_kept,
            Box::new(move |scene, loads| {
                let force = force(scene, joint);
                let slides = scene.slides(joint);
                for (drive, slide) in loads.drives[joint].iter_mut().zip(slides) {
                    *drive = *drive + dot(force, slide);
                }
            }),
        );
    }
}
