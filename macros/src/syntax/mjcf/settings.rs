//! `<compiler>` and `<option>`: how a file is interpreted, and global loads.

use roxmltree::Node;

use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;

use super::element::bare;

/// How a file is interpreted.
pub struct Settings {
    pub is_radian: bool,
    /// The axes of Euler angles, and whether they are fixed instead of rotating with the body.
    pub order: [usize; 3],
    pub is_fixed: bool,
    /// Whether all bodies take their mass from geoms, or none does. By default, bodies without
    /// `<inertial>` do.
    pub from_geoms: Option<bool>,
    pub gravity: Option<[Decimal; 3]>,
    pub has_gravity: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            is_radian: false,
            order: [0, 1, 2],
            is_fixed: false,
            from_geoms: None,
            gravity: None,
            has_gravity: true,
        }
    }
}

const NOTHING: [&str; 2] = ["0", "false"];
/// Attributes of `<compiler>` that do not affect the motion.
const SKIPPED: [&str; 13] = [
    "autolimits",
    "strippath",
    "meshdir",
    "texturedir",
    "assetdir",
    "discardvisual",
    "usethread",
    "fusestatic",
    "convexhull",
    "exactmeshinertia",
    "saveinertial",
    "alignfree",
    "inertiagrouprange",
];
/// Flags that do not affect forward dynamics, since contact and limits are not modelled.
const FLAGS: [&str; 16] = [
    "contact",
    "limit",
    "frictionloss",
    "warmstart",
    "filterparent",
    "clampctrl",
    "sensor",
    "midphase",
    "nativeccd",
    "eulerdamp",
    "autoreset",
    "energy",
    "fwdinv",
    "multiccd",
    "island",
    "refsafe",
];

impl Reader<'_> {
    /// `<compiler>`
    pub fn compiler(&mut self, node: Node<'_, '_>, settings: &mut Settings) {
        let element = bare(node);
        let own = [
            "angle",
            "coordinate",
            "eulerseq",
            "inertiafromgeom",
            "balanceinertia",
            "boundmass",
            "boundinertia",
            "settotalmass",
        ];
        self.check_names(&element, &[&own, &SKIPPED]);
        let changes = "masses and inertias are those of the file: write them as they are";
        self.refuse(
            &element,
            &[
                ("balanceinertia", &NOTHING, changes),
                ("boundmass", &NOTHING, changes),
                ("boundinertia", &NOTHING, changes),
                ("settotalmass", &["-1"], changes),
                ("coordinate", &["local"], "only local coordinates are read"),
                (
                    "inertiagrouprange",
                    &["0", "5"],
                    "geoms of all groups have mass",
                ),
            ],
        );
        if let Some(word) = self.word(node, "angle", &["degree", "radian"]) {
            settings.is_radian = word == 1;
        }
        if let Some(word) = self.word(node, "inertiafromgeom", &["false", "true", "auto"]) {
            settings.from_geoms = (word < 2).then_some(word == 1);
        }
        if let Some(text) = node.attribute("eulerseq") {
            self.order(node, text, settings);
        }
    }

    fn order(&mut self, node: Node<'_, '_>, text: &str, settings: &mut Settings) {
        let axes = |letters: &str| -> Option<Vec<usize>> {
            text.chars().map(|letter| letters.find(letter)).collect()
        };
        let (moving, fixed) = (axes("xyz"), axes("XYZ"));
        settings.is_fixed = moving.is_none();
        if let Some(Ok(order)) = moving.or(fixed).map(<[usize; 3]>::try_from) {
            settings.order = order;
        } else {
            let message = "`eulerseq` is three letters of `xyz`, or three of `XYZ`";
            self.report::<()>(node, message);
        }
    }

    /// The index of a word among the permitted values of an attribute.
    pub fn word(&mut self, node: Node<'_, '_>, name: &str, known: &[&str]) -> Option<usize> {
        let text = node.attribute(name)?;
        let found = known.iter().position(|word| *word == text);
        if found.is_none() {
            let all = known.join("`, `");
            self.report::<()>(
                node,
                format!("`{name}` is one of `{all}`, and this is `{text}`"),
            );
        }
        found
    }

    /// `<option>`
    pub fn option(&mut self, node: Node<'_, '_>, settings: &mut Settings) {
        let element = bare(node);
        let fluid = "forces of a fluid are not read: write them in `forces` and `moments`";
        self.refuse(
            &element,
            &[
                ("density", &NOTHING, fluid),
                ("viscosity", &NOTHING, fluid),
                ("wind", &NOTHING, fluid),
            ],
        );
        if element.has("gravity") {
            settings.gravity = Some(self.triple(&element, "gravity", "0 0 -9.81"));
        }
        for flag in self.parts(node, &["flag"], &[]) {
            for attribute in flag.attributes() {
                let is_on = attribute.value() == "enable";
                match attribute.name() {
                    "gravity" => settings.has_gravity = is_on,
                    name if FLAGS.contains(&name) || is_on => {}
                    name => {
                        let message = format!(
                            "`{name}` cannot be switched off here: leave out what it is about"
                        );
                        self.report::<()>(flag, message);
                    }
                }
            }
        }
    }
}
