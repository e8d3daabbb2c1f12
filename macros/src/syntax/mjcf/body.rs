//! The bodies of a file; each stands inside its carrier.

use proc_macro2::Ident;
use roxmltree::Node;

use crate::errors::Extent;
use crate::syntax::Part;
use crate::syntax::xml::names::Names;
use crate::syntax::xml::reader::Reader;
use crate::syntax::xml::{Beside, LINKS};

use super::classes::{Classes, bare};
use super::joint::{Joint, Motion};
use super::place::{PLACE, Place, product, rotate};
use super::settings::Settings;

pub struct Body {
    /// The name in the file; empty if it has none.
    pub name: String,
    pub ident: Ident,
    /// The index of its carrier; `None` for the world.
    pub parent: Option<usize>,
    pub place: Place,
    pub joints: Vec<Joint>,
    /// Its mass properties; empty for a frame.
    pub parts: Vec<Part>,
    pub extent: Extent,
}

const KNOWN: [&str; 5] = ["name", "childclass", "mocap", "gravcomp", "user"];
const PARTS: [&str; 5] = ["body", "joint", "freejoint", "inertial", "geom"];
const SKIPPED: [&str; 3] = ["site", "camera", "light"];

/// The state of reading bodies.
pub struct Reading<'a> {
    pub beside: Beside<'a>,
    pub classes: &'a Classes,
    pub settings: &'a Settings,
    pub names: &'a mut Names,
    /// The names of all bodies, as in the file and as in the description.
    pub idents: Vec<(String, Ident)>,
    pub bodies: Vec<Body>,
}

impl Reading<'_> {
    /// All bodies in `<worldbody>`, each after its carrier.
    pub fn world(&mut self, world: Node<'_, '_>, reader: &mut Reader<'_>) {
        self.name(world, reader);
        let mut pending = Vec::new();
        let inside = |node, reader: &mut Reader<'_>| {
            let mut all: Vec<Node<'_, '_>> = reader.parts(node, &PARTS, &SKIPPED);
            all.reverse();
            all
        };
        for node in inside(world, reader) {
            match node.tag_name().name() {
                "body" => pending.push((node, None::<usize>, None::<&str>)),
                "geom" => reader.skip("geom"),
                _ => {
                    reader.report::<()>(node, "this belongs in a body, and not in the world");
                }
            }
        }
        while let Some((node, parent, around)) = pending.pop() {
            if self.bodies.len() == LINKS {
                reader.report::<()>(node, format!("there are more than {LINKS} bodies"));
                return;
            }
            let class = node.attribute("childclass").or(around);
            reader.owner.clear();
            self.classes.check_class(node, reader);
            let parts = inside(node, reader);
            self.body(node, &parts, (parent, class), reader);
            let number = self.bodies.len() - 1;
            let children = parts.iter().filter(|part| part.tag_name().name() == "body");
            pending.extend(children.map(|child| (*child, Some(number), class)));
        }
    }

    /// Names all bodies, in the order of the file.
    fn name(&mut self, world: Node<'_, '_>, reader: &mut Reader<'_>) {
        let bodies = world
            .descendants()
            .filter(|node| node.tag_name().name() == "body");
        for node in bodies {
            let number = self.idents.len() + 1;
            let given = node.attribute("name").filter(|name| !name.is_empty());
            let given = given.map_or_else(|| format!("body_{number}"), str::to_owned);
            let ident = reader.take(node, &given, |name, span| self.names.link(name, span));
            self.idents.push((given, ident));
        }
    }

    fn body(
        &mut self,
        node: Node<'_, '_>,
        parts: &[Node<'_, '_>],
        (parent, class): (Option<usize>, Option<&str>),
        reader: &mut Reader<'_>,
    ) {
        let (given, ident) = self.idents[self.bodies.len()].clone();
        let element = bare(node);
        reader.owner = format!(" `{given}`");
        reader.check_names(&element, &[&KNOWN, &PLACE]);
        let moved = "a body that is moved from outside is not read: write its joint `.driven(..)`";
        let lifted = "compensated gravity is not read: write it in `forces`";
        reader.refuse(
            &element,
            &[("mocap", &["false"], moved), ("gravcomp", &["0"], lifted)],
        );
        let place = reader.place(&element, self.settings);
        let of = |tags: &[&str]| -> Vec<Node<'_, '_>> {
            let all = parts.iter().rev();
            let all = all.filter(|part| tags.contains(&part.tag_name().name()));
            all.copied().collect()
        };
        reader.owner = format!(" of body `{given}`");
        let inertials = of(&["inertial"]);
        let inertial = reader.one(&inertials, "inertial");
        let classes = (self.classes, class);
        let substance = reader.made_of(inertial, &of(&["geom"]), classes, self.settings);
        let mut joints = Vec::new();
        for (place, node) in of(&["joint", "freejoint"]).into_iter().enumerate() {
            joints.extend(self.joint(node, (&given, place), classes, reader));
        }
        let is_free = |joint: &Joint| joint.kind == Motion::Free;
        if let Some(free) = joints.iter().find(|joint| is_free(joint))
            && (joints.len() > 1 || parent.is_some())
        {
            let message = "a free joint is the only one of a body in the world";
            reader.errors.push(free.extent, message);
        }
        reader.owner.clear();
        self.bodies.push(Body {
            name: given,
            ident,
            parent,
            place,
            joints,
            parts: substance,
            extent: reader.at(node),
        });
    }

    fn joint(
        &mut self,
        node: Node<'_, '_>,
        (body, place): (&str, usize),
        classes: (&Classes, Option<&str>),
        reader: &mut Reader<'_>,
    ) -> Option<Joint> {
        let given = match (node.attribute("name"), place) {
            (Some(name), _) => name.to_owned(),
            (None, 0) => format!("{body}_joint"),
            (None, _) => format!("{body}_joint_{}", place + 1),
        };
        let links: Vec<&Ident> = self.idents.iter().map(|(_, ident)| ident).collect();
        let ident = reader.take(node, &given, |name, span| {
            self.names.joint(name, &links, span)
        });
        let locked = self.beside.locked(&ident);
        let joint = reader.jointed(node, ident, locked, classes, self.settings);
        if joint.is_none() {
            reader.lost.push(given);
        }
        joint
    }
}

/// For each body, whether it or a body that it carries has mass.
pub fn massive(bodies: &[Body], beside: Beside<'_>) -> Vec<bool> {
    let has = |body: &Body| !body.parts.is_empty() || beside.gives_mass(&body.ident);
    let mut found: Vec<bool> = bodies.iter().map(has).collect();
    for (number, body) in bodies.iter().enumerate().rev() {
        if let Some(parent) = body.parent.filter(|_| found[number]) {
            found[parent] = true;
        }
    }
    found
}

/// The place of each body in the drawn pose: its origin, and its rotation.
pub fn poses(bodies: &[Body]) -> Vec<([f64; 3], [f64; 4])> {
    let mut found: Vec<([f64; 3], [f64; 4])> = Vec::new();
    for body in bodies {
        let ground = ([0.0; 3], [1.0, 0.0, 0.0, 0.0]);
        let (origin, turned) = body.parent.map_or(ground, |parent| found[parent]);
        let step = rotate(turned, [0, 1, 2].map(|part| body.place.place[part].value()));
        let origin = [0, 1, 2].map(|part| origin[part] + step[part]);
        found.push((origin, product(turned, body.place.quaternion())));
    }
    found
}
