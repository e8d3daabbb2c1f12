//! `<equality>`: joints that close loops.

use roxmltree::Node;

use crate::errors::Extent;
use crate::syntax::xml::reader::Reader;

use super::body::Body;
use super::describe::Writer;
use super::element::bare;
use super::place::{inverse, product, rotate};

/// A connection of two bodies: points of both, and the rotation of the second relative to the
/// first.
pub struct Closing {
    name: String,
    /// Indices of bodies; `None` for the world.
    bodies: [Option<usize>; 2],
    points: [[f64; 3]; 2],
    /// The rotation, for a weld.
    turned: Option<[f64; 4]>,
    extent: Extent,
}

const KNOWN: [&str; 13] = [
    "name",
    "class",
    "active",
    "solref",
    "solimp",
    "body1",
    "body2",
    "anchor",
    "site1",
    "site2",
    "relpose",
    "torquescale",
    "user",
];
/// The rounding error of lengths of about one.
const ROUNDING: f64 = 1e-15;

type Pose = ([f64; 3], [f64; 4]);

impl Reader<'_> {
    pub fn closings(
        &mut self,
        node: Node<'_, '_>,
        bodies: &[Body],
        poses: &[Pose],
        found: &mut Vec<Closing>,
    ) {
        let parts = self.parts(node, &["connect", "weld", "joint", "tendon"], &[]);
        let is_closing =
            |node: &Node<'_, '_>| ["connect", "weld"].contains(&node.tag_name().name());
        for node in parts.into_iter().filter(is_closing) {
            if node.attribute("active") != Some("false") {
                found.extend(self.closing(node, found.len(), (bodies, poses)));
            }
        }
    }

    fn closing(
        &mut self,
        node: Node<'_, '_>,
        number: usize,
        (bodies, poses): (&[Body], &[Pose]),
    ) -> Option<Closing> {
        let element = bare(node);
        self.check_names(&element, &[&KNOWN]);
        let sites = "places are written by `body1`, `body2` and `anchor`";
        let relative = "a weld holds bodies as they are drawn: leave it out";
        self.refuse(
            &element,
            &[
                ("site1", &[], sites),
                ("site2", &[], sites),
                ("relpose", &["0", "1"], relative),
            ],
        );
        let first = self.attribute(node, "body1")?.to_owned();
        let first = self.body_named(node, &first, bodies)?;
        let second = match element.get("body2") {
            Some(name) => self.body_named(node, name, bodies)?,
            None => None,
        };
        let ground = ([0.0; 3], [1.0, 0.0, 0.0, 0.0]);
        let pose = |body: Option<usize>| body.map_or(ground, |body| poses[body]);
        let of = |(origin, turned): Pose, place: [f64; 3]| {
            let from = [0, 1, 2].map(|part| place[part] - origin[part]);
            clean(rotate(inverse(turned), from))
        };
        let (one, two) = (pose(first), pose(second));
        let is_weld = node.tag_name().name() == "weld";
        let (place, turned) = if is_weld {
            (two.0, Some(product(inverse(one.1), two.1)))
        } else {
            self.attribute(node, "anchor")?;
            let anchor = self.triple(&element, "anchor", "0 0 0");
            let anchor = rotate(one.1, [0, 1, 2].map(|part| anchor[part].value()));
            ([0, 1, 2].map(|part| one.0[part] + anchor[part]), None)
        };
        let word = node.attribute("name");
        let word = word.map_or_else(|| format!("closing_{}", number + 1), str::to_owned);
        Some(Closing {
            name: word,
            bodies: [first, second],
            points: [of(one, place), of(two, place)],
            turned,
            extent: self.at(node),
        })
    }

    #[allow(clippy::option_option, reason = "outer: reported; inner: the world")]
    fn body_named(
        &mut self,
        node: Node<'_, '_>,
        name: &str,
        bodies: &[Body],
    ) -> Option<Option<usize>> {
        if name == "world" {
            return Some(None);
        }
        let found = bodies.iter().position(|body| body.name == name);
        if found.is_none() {
            let names = bodies.iter().map(|body| body.name.as_str());
            self.no_such::<()>(node, ("body", name), names);
        }
        found.map(Some)
    }
}

impl Writer<'_> {
    /// The joints that close loops, written after those that carry bodies; `numbers` are the
    /// indices of the described bodies.
    pub fn close(
        &mut self,
        closings: &[Closing],
        numbers: &[usize],
        name: &mut dyn FnMut(&str) -> proc_macro2::Ident,
    ) {
        for closing in closings {
            let ident = name(&closing.name);
            // the world can only be the carrier, so the body comes second
            let mut ends = [0, 1].map(|end| (closing.bodies[end], closing.points[end]));
            let mut turned = closing.turned;
            if ends[1].0.is_none() {
                ends.swap(0, 1);
                turned = turned.map(inverse);
            }
            let texts = ends.map(|(body, point)| {
                let place = format!("({}, {}, {})", point[0], point[1], point[2]);
                let body = body.map(|body| numbers[body]);
                self.end(body, &ident.to_string(), &place, closing.extent)
            });
            let [first, second] = texts;
            let text = match turned {
                None => format!("spherical({first}, {second})"),
                Some(turned) => format!("weld({first}, {second}){}", in_turns(turned)),
            };
            self.define(&ident, &text, closing.extent);
        }
    }
}

/// The vector with components that are only rounding error set to zero.
fn clean(of: [f64; 3]) -> [f64; 3] {
    let size = of.iter().fold(1.0_f64, |size, part| size.max(part.abs()));
    of.map(|part| {
        if part.abs() < ROUNDING * size {
            0.0
        } else {
            part
        }
    })
}

/// Rotations about z, y and x in sequence. The last two are computed from what the first leaves, so
/// that no accuracy is lost near a right angle about y.
fn in_turns(turned: [f64; 4]) -> String {
    let [x, y, z] =
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| rotate(turned, axis));
    let yaw = x[1].atan2(x[0]);
    let (sine, cosine) = yaw.sin_cos();
    let pitch = (-x[2]).atan2(x[0].hypot(x[1]));
    let roll = (sine * z[0] - cosine * z[1]).atan2(cosine * y[1] - sine * y[0]);
    let axes = ["(0, 0, 1)", "(0, 1, 0)", "(1, 0, 0)"];
    let all = axes.iter().zip(clean([yaw, pitch, roll]));
    let all = all.filter(|(_, angle)| *angle != 0.0);
    let all = all.map(|(axis, angle)| format!(".turned(body{axis}, {angle})"));
    all.collect::<Vec<String>>().concat()
}
