//! The mass properties of a body: `<inertial>`, or its geoms.

use roxmltree::Node;

use crate::errors::Extent;
use crate::syntax::Part;
use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;

use super::classes::{Classes, Element, bare};
use super::place::{PLACE, Place, shortest, tuple, turned, turned_inertia};
use super::settings::Settings;
use crate::syntax::xml::written::written;

/// A form, its mass, and the place of its center of mass G.
struct Substance {
    form: String,
    mass: String,
    place: String,
    extent: Extent,
}

impl Substance {
    fn part(&self, reader: &mut Reader<'_>) -> Option<Part> {
        let mut read = |text: &str| written(text, self.extent, reader.span, reader.errors);
        Some(Part {
            form: read(&self.form)?,
            mass: Some(read(&self.mass)),
            point: Some(read(&self.place)),
        })
    }
}

const INERTIAL: [&str; 4] = ["mass", "diaginertia", "fullinertia", "class"];
pub const GEOM: [&str; 9] = [
    "name",
    "class",
    "type",
    "size",
    "mass",
    "density",
    "fromto",
    "shellinertia",
    "mesh",
];
/// Attributes of geoms that concern appearance and contact only.
pub const LOOKS: [&str; 22] = [
    "contype",
    "conaffinity",
    "condim",
    "group",
    "priority",
    "friction",
    "solmix",
    "solref",
    "solimp",
    "margin",
    "gap",
    "hfield",
    "fitscale",
    "material",
    "rgba",
    "user",
    "fluidshape",
    "fluidcoef",
    "adhesion",
    "surfacevel",
    "octree",
    "castshadow",
];
const TYPES: [&str; 9] = [
    "sphere",
    "capsule",
    "cylinder",
    "box",
    "ellipsoid",
    "plane",
    "hfield",
    "mesh",
    "sdf",
];

impl Reader<'_> {
    /// The parts of a body; empty if it has no mass.
    pub fn made_of(
        &mut self,
        inertial: Option<Node<'_, '_>>,
        geoms: &[Node<'_, '_>],
        (classes, class): (&Classes, Option<&str>),
        settings: &Settings,
    ) -> Vec<Part> {
        let uses_geoms = settings.from_geoms.unwrap_or(inertial.is_none());
        let mut found = Vec::new();
        for geom in geoms {
            let element = classes.of(*geom, class, self);
            self.check_names(&element, &[&GEOM, &LOOKS, &PLACE]);
            if uses_geoms {
                found.extend(self.geom(&element, settings));
            }
        }
        // where geoms count but none has mass, `<inertial>` remains
        if let Some(node) = inertial.filter(|_| found.is_empty()) {
            found.extend(self.inertial(node, settings));
        }
        let parts = found.iter().filter_map(|one| one.part(self));
        parts.collect()
    }

    fn inertial(&mut self, node: Node<'_, '_>, settings: &Settings) -> Option<Substance> {
        let element = bare(node);
        self.check_names(&element, &[&INERTIAL, &PLACE]);
        self.attribute(node, "mass")?;
        let mass = self.single(&element, "mass", "1");
        let place = self.place(&element, settings);
        let (entries, form) = if element.has("fullinertia") {
            if element.has("diaginertia") || !place.turns.is_empty() {
                let message =
                    "`fullinertia` is in the axes of the body: leave `diaginertia` and turns out";
                self.report::<()>(node, message);
            }
            let all = self.list(&element, "fullinertia", 6..=6, "1 1 1 0 0 0");
            let names = ["xx", "yy", "zz", "xy", "zx", "yz"];
            let entries = names.iter().zip(&all);
            let entries: Vec<String> = entries
                .map(|(name, entry)| format!("{name}: {}", entry.literal()))
                .collect();
            (all, format!("tensor {{ {} }}", entries.join(", ")))
        } else {
            let message = "it has no `diaginertia` and no `fullinertia`";
            if !element.has("diaginertia") {
                return self.report(node, message);
            }
            let all = self.list(&element, "diaginertia", 3..=3, "1 1 1");
            let form = format!("principal{}{}", tuple(&all), turned_inertia(&place.turns));
            (all, form)
        };
        if mass.is_zero() && entries.iter().all(Decimal::is_zero) {
            return None;
        }
        Some(Substance {
            form,
            mass: mass.literal(),
            place: tuple(&place.place),
            extent: self.at(node),
        })
    }

    /// A geom with mass.
    fn geom(&mut self, element: &Element<'_, '_>, settings: &Settings) -> Option<Substance> {
        let node = element.node;
        let plain = if element.has("mesh") {
            "mesh"
        } else {
            "sphere"
        };
        let word = element.get("type").unwrap_or(plain);
        let Some(kind) = TYPES.iter().position(|known| *known == word) else {
            let all = TYPES.join("`, `");
            return self.report(
                node,
                format!("`type` is one of `{all}`, and this is `{word}`"),
            );
        };
        let hollow = "the mass of a geom fills it: write `<inertial>`";
        self.refuse(element, &[("shellinertia", &["false"], hollow)]);
        let group = self.single(element, "group", "0").value();
        let [first, last] = settings.groups;
        if group < first || group > last {
            return None;
        }
        let density = self.single(element, "density", "1000");
        let mass = element
            .has("mass")
            .then(|| self.single(element, "mass", "0"));
        if mass.as_ref().unwrap_or(&density).is_zero() || matches!(word, "plane" | "hfield") {
            return None;
        }
        if kind < 5 && element.has("mesh") {
            let message = "a solid that is fitted to a mesh is not computed here: leave `mesh` out, or write `<inertial>`";
            return self.report(node, message);
        }
        if kind > 4 {
            let message = "the mass of a mesh is not computed: write `<inertial>`, or `mass=\"0\"`";
            return self.report(node, message);
        }
        let place = self.placed_geom(element, word, settings);
        let (center, turns, length) = place?;
        let size = self.size(element, kind, length)?;
        let mass = mass.map_or_else(
            || format!("({}) * {}", density.literal(), volume(kind, &size)),
            |mass| mass.literal(),
        );
        let form = form(kind, &size, &mass);
        Some(Substance {
            form: format!("{form}{turns}"),
            mass,
            place: center,
            extent: self.at(node),
        })
    }

    /// The place and rotation of its center; and half its length, if it is given by its two ends.
    fn placed_geom(
        &mut self,
        element: &Element<'_, '_>,
        word: &str,
        settings: &Settings,
    ) -> Option<(String, String, Option<String>)> {
        if !element.has("fromto") {
            let Place { place, turns } = self.place(element, settings);
            return Some((tuple(&place), turned_inertia(&turns), None));
        }
        if element.has("pos") {
            let message = "`fromto` says where it is already: leave `pos` out";
            return self.report(element.node, message);
        }
        if word == "sphere" {
            return self.report(element.node, "a sphere has no `fromto`");
        }
        let ends = self.list(element, "fromto", 6..=6, "0 0 0 0 0 1");
        let (from, to) = ends.split_at(3);
        let pairs = || from.iter().zip(to);
        let middle = pairs().map(|(a, b)| format!("({} + {}) / 2", a.literal(), b.literal()));
        let middle: Vec<String> = middle.collect();
        let squares =
            pairs().map(|(a, b)| format!("({} - ({})).powi(2)", a.literal(), b.literal()));
        let squares: Vec<String> = squares.collect();
        if pairs().all(|(a, b)| a.is_same(b)) {
            return self.report(element.node, "`fromto`: both ends are in one place");
        }
        let turns = along(from, to);
        let half = format!("(({}).sqrt() / 2)", squares.join(" + "));
        Some((format!("({})", middle.join(", ")), turns, Some(half)))
    }

    /// Its dimensions, each as an expression.
    fn size(
        &mut self,
        element: &Element<'_, '_>,
        kind: usize,
        half: Option<String>,
    ) -> Option<Vec<String>> {
        // if given by two points, a box and an ellipsoid are as wide along x as along y
        let own = [1, 2, 2, 3, 3][kind] - usize::from(half.is_some());
        let (own, is_square) = match (kind, &half) {
            (3 | 4, Some(_)) => (1, true),
            _ => (own, false),
        };
        if !element.has("size") {
            return self.report(element.node, "it has no attribute `size`");
        }
        let all = self.list(element, "size", own..=3, "1 1 1");
        let mut lengths: Vec<String> = all.iter().take(own).map(Decimal::literal).collect();
        if is_square {
            lengths.push(lengths[0].clone());
        }
        lengths.extend(half);
        Some(lengths)
    }
}

/// The rotation that takes z to the line through two points.
fn along(from: &[Decimal], to: &[Decimal]) -> String {
    let is_along =
        |axis: usize| (0..3).all(|other| from[other].is_same(&to[other]) == (other != axis));
    let unit = (0..3).find(|axis| is_along(*axis));
    if unit == Some(2) {
        return String::new();
    }
    if let (Some(axis), [x, y, z]) = (unit, [0, 1, 2].map(|part| &from[part])) {
        // solids are symmetric, so it does not matter which way the line points
        let extent = [x, y, z][axis].extent;
        let mut direction = [0, 1, 2].map(|_| Decimal::zero(extent));
        direction[axis] = Decimal::one(extent);
        return shortest(&direction).map_or(String::new(), |turn| turned(&[turn]));
    }
    let [x, y, z] =
        [0, 1, 2].map(|part| format!("({} - ({}))", from[part].literal(), to[part].literal()));
    format!(".turned(body(-{y}, {x}, 0), ({x}.powi(2) + {y}.powi(2)).sqrt().atan2({z}))")
}

/// The volume of a solid with these dimensions.
fn volume(kind: usize, lengths: &[String]) -> String {
    match (kind, lengths) {
        (0, [r]) => format!("4 / 3 * PI * {r}.powi(3)"),
        (1, [r, h]) => format!("PI * ({r}).powi(2) * (2 * {h} + 4 / 3 * {r})"),
        (2, [r, h]) => format!("2 * PI * ({r}).powi(2) * {h}"),
        (3, [x, y, z]) => format!("8 * {x} * {y} * {z}"),
        _ => format!("4 / 3 * PI * {}", lengths.join(" * ")),
    }
}

/// A solid with these dimensions.
fn form(kind: usize, lengths: &[String], mass: &str) -> String {
    match (kind, lengths) {
        (0, [r]) => format!("sphere({r})"),
        (1, [r, h]) => capsule(r, h, mass),
        (2, [r, h]) => format!("cylinder({r}, 2 * {h})"),
        (3, [x, y, z]) => format!("cuboid(2 * {x}, 2 * {y}, 2 * {z})"),
        _ => format!("ellipsoid({})", lengths.join(", ")),
    }
}

/// A cylinder with a hemisphere on each end. The mass is divided among them by volume.
fn capsule(r: &str, h: &str, mass: &str) -> String {
    let (square, ends) = (
        format!("({r}).powi(2)"),
        format!("(2 * {r} / (3 * {h} + 2 * {r}))"),
    );
    let middle = format!("(1 - {ends})");
    let of_middle = format!("{middle} * ({square} / 4 + ({h}).powi(2) / 3)");
    let of_ends = format!("{ends} * (2 / 5 * {square} + ({h}).powi(2) + 3 / 4 * {h} * {r})");
    let across = format!("({mass}) * ({of_middle} + {of_ends})");
    let along = format!("({mass}) * {square} * ({middle} / 2 + {ends} * 2 / 5)");
    format!("principal({across}, {across}, {along})")
}
