//! `<compiler>` and `<option>`: how a file is interpreted, and global loads.

use roxmltree::Node;

use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;

use super::classes::{Element, bare};

/// How a file is interpreted.
pub struct Settings {
    pub is_radian: bool,
    /// The axes of Euler angles, and whether each is fixed instead of rotating with the body.
    pub order: [(usize, bool); 3],
    /// Whether all bodies take their mass from geoms, or none does. By default, bodies without
    /// `<inertial>` do.
    pub from_geoms: Option<bool>,
    /// The first and the last group of the geoms that have mass.
    pub groups: [f64; 2],
    pub gravity: Option<[Decimal; 3]>,
    pub has_gravity: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            is_radian: false,
            order: [0, 1, 2].map(|axis| (axis, false)),
            from_geoms: None,
            groups: [0.0, 5.0],
            gravity: None,
            has_gravity: true,
        }
    }
}

/// Attributes of `<compiler>` that change the motion or how the file is interpreted.
const COMPILER: [&str; 9] = [
    "angle",
    "coordinate",
    "eulerseq",
    "inertiafromgeom",
    "inertiagrouprange",
    "balanceinertia",
    "boundmass",
    "boundinertia",
    "settotalmass",
];
/// Attributes of `<compiler>` that do not affect the motion.
const SKIPPED: [&str; 17] = [
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
    "conflict",
    "fitaabb",
    "passthrough",
    "savecanonical",
    "savecompiled",
];
/// Attributes of `<option>` that change the motion.
const OPTION: [&str; 5] = [
    "gravity",
    "density",
    "viscosity",
    "wind",
    "actuatorgroupdisable",
];
/// Attributes of `<option>` that do not affect forward dynamics in continuous time.
const SOLVER: [&str; 25] = [
    "timestep",
    "apirate",
    "impratio",
    "integrator",
    "cone",
    "jacobian",
    "solver",
    "iterations",
    "tolerance",
    "ls_iterations",
    "ls_tolerance",
    "noslip_iterations",
    "noslip_tolerance",
    "ccd_iterations",
    "ccd_tolerance",
    "mpr_iterations",
    "mpr_tolerance",
    "sdf_iterations",
    "sdf_initpoints",
    "sleep_tolerance",
    "magnetic",
    "o_margin",
    "o_solref",
    "o_solimp",
    "o_friction",
];
/// Flags that can only be on.
const ON: [&str; 6] = [
    "constraint",
    "equality",
    "spring",
    "damper",
    "passive",
    "actuation",
];
/// Flags that do not affect forward dynamics, since contact and limits are not modeled.
const FLAGS: [&str; 22] = [
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
    "diagexact",
    "invdiscrete",
    "ipc",
    "override",
    "sleep",
    "speculative",
];

impl Reader<'_> {
    /// `<compiler>`
    pub fn compiler(&mut self, node: Node<'_, '_>, settings: &mut Settings) {
        let element = bare(node);
        self.check_names(&element, &[&COMPILER, &SKIPPED]);
        self.parts(node, &[], &["lengthrange"]);
        let changes = "masses and inertias are those of the file: write them as they are";
        self.refuse(
            &element,
            &[
                ("balanceinertia", &["false"], changes),
                ("boundmass", &["0"], changes),
                ("boundinertia", &["0"], changes),
                ("settotalmass", &["-1", "0"], changes),
                ("coordinate", &["local"], "only local coordinates are read"),
            ],
        );
        if let Some(word) = self.word(&element, "angle", &["degree", "radian"]) {
            settings.is_radian = word == 1;
        }
        if let Some(word) = self.word(&element, "inertiafromgeom", &["false", "true", "auto"]) {
            settings.from_geoms = (word < 2).then_some(word == 1);
        }
        if element.has("inertiagrouprange") {
            let range = self.list(&element, "inertiagrouprange", 2..=2, "0 5");
            settings.groups = [0, 1].map(|end| range[end].value());
        }
        if let Some(text) = node.attribute("eulerseq") {
            self.order(node, text, settings);
        }
    }

    fn order(&mut self, node: Node<'_, '_>, text: &str, settings: &mut Settings) {
        let axis = |letter: char| "xyzXYZ".find(letter).map(|place| (place % 3, place > 2));
        let axes: Option<Vec<(usize, bool)>> = text.chars().map(axis).collect();
        if let Some(Ok(order)) = axes.map(<[_; 3]>::try_from) {
            settings.order = order;
        } else {
            let message = "`eulerseq` is three letters of `xyzXYZ`";
            self.report::<()>(node, message);
        }
    }

    /// The index of a word among the permitted values of an attribute.
    pub fn word(&mut self, element: &Element<'_, '_>, name: &str, known: &[&str]) -> Option<usize> {
        let text = element.get(name)?;
        let found = known.iter().position(|word| *word == text);
        if found.is_none() {
            let all = known.join("`, `");
            self.report::<()>(
                element.node,
                format!("`{name}` is one of `{all}`, and this is `{text}`"),
            );
        }
        found
    }

    /// `<option>`
    pub fn option(&mut self, node: Node<'_, '_>, settings: &mut Settings) {
        let element = bare(node);
        self.check_names(&element, &[&OPTION, &SOLVER]);
        let fluid = "forces of a fluid are not read: write them in `forces` and `moments`";
        self.refuse(
            &element,
            &[
                ("density", &["0"], fluid),
                ("viscosity", &["0"], fluid),
                ("wind", &["0"], fluid),
                (
                    "actuatorgroupdisable",
                    &[],
                    "all actuators act: leave out those that do not",
                ),
            ],
        );
        if element.has("gravity") {
            settings.gravity = Some(self.triple(&element, "gravity", "0 0 -9.81"));
        }
        for flag in self.parts(node, &["flag"], &[]) {
            self.flags(flag, settings);
        }
    }

    /// `<flag>`
    fn flags(&mut self, node: Node<'_, '_>, settings: &mut Settings) {
        let element = bare(node);
        self.check_names(&element, &[&["gravity"], &ON, &FLAGS]);
        for attribute in node.attributes() {
            let name = attribute.name();
            let is_off = self.word(&element, name, &["enable", "disable"]) == Some(1);
            if name == "gravity" {
                settings.has_gravity = !is_off;
            } else if ON.contains(&name) && is_off {
                let message =
                    format!("`{name}` cannot be switched off here: leave out what it is about");
                self.report::<()>(node, message);
            }
        }
    }
}
