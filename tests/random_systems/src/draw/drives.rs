//! What drives joints at random.

use super::{DRIVES, Drawing};
use crate::law::kind::Kind;
use crate::law::space::{apply, dot, transposed};

/// The coordinates of a joint that are one freedom each: how a drive names them, its unit, and which
/// of the freedoms.
fn coordinates(kind: Kind) -> &'static [(&'static str, &'static str, usize)] {
    match kind {
        Kind::Revolute(_) | Kind::Screw(..) => &[("", "N * m", 0)],
        Kind::Prismatic(_) => &[("", "N", 0)],
        Kind::Cylindrical(_) => &[(".position", "N", 0), (".angle", "N * m", 1)],
        Kind::Universal(..) => &[(".angle_1", "N * m", 0), (".angle_2", "N * m", 1)],
        Kind::Planar(..) => &[(".angle", "N * m", 2)],
        _ => &[],
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
                Box::new(move |scene, loads| {
                    let drive = &mut loads.drives[joint][*freedom];
                    *drive = *drive + size(scene);
                }),
            );
        }
    }

    /// Inputs that drive each freedom, in the place of open drives.
    pub fn open_drives(&mut self, joint: usize) {
        for (_, _, freedom) in coordinates(self.links[joint].kind) {
            // numbered when all other inputs are
            self.open.push((joint, *freedom, usize::MAX));
        }
    }

    pub fn open_inputs(&mut self) {
        for number in 0..self.open.len() {
            let (joint, freedom, _) = self.open[number];
            let mut all = coordinates(self.links[joint].kind).iter();
            let Some((word, unit, _)) = all.find(|(_, _, other)| *other == freedom) else {
                continue;
            };
            let (name, place) = self.numbers.input(unit);
            self.open[number].2 = place;
            self.tops[DRIVES].push(format!("o{joint}_{freedom} = {name}.on(j{joint}{word})"));
            self.acting.push(Box::new(move |scene, loads| {
                let drive = &mut loads.drives[joint][freedom];
                *drive = *drive + scene.inputs[place];
            }));
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
