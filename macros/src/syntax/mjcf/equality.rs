//! `<equality>`: joints that close loops.

use roxmltree::Node;

use crate::errors::Extent;
use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;

use super::body::Body;
use super::classes::{Classes, Element};
use super::describe::Writer;
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

/// Attributes of all equalities. `solref` and `solimp` make them soft, and here they hold exactly.
pub const EQUALITY: [&str; 5] = ["name", "class", "active", "solref", "solimp"];
const CONNECT: [&str; 5] = ["body1", "body2", "anchor", "site1", "site2"];
const WELD: [&str; 2] = ["relpose", "torquescale"];
/// The rounding error of lengths of about one.
const ROUNDING: f64 = 1e-15;

type Pose = ([f64; 3], [f64; 4]);

impl Reader<'_> {
    pub fn closings(
        &mut self,
        node: Node<'_, '_>,
        classes: &Classes,
        (bodies, poses): (&[Body], &[Pose]),
        found: &mut Vec<Closing>,
    ) {
        let parts = self.parts(node, &["connect", "weld", "joint", "tendon"], &[]);
        let is_closing =
            |node: &Node<'_, '_>| ["connect", "weld"].contains(&node.tag_name().name());
        for node in parts.into_iter().filter(is_closing) {
            if let Some(element) = self.active(node, classes) {
                found.extend(self.closing(&element, found.len(), (bodies, poses)));
            }
        }
    }

    /// An equality with the attributes of its class; `None` if it is switched off.
    pub fn active<'n, 'd>(
        &mut self,
        node: Node<'n, 'd>,
        classes: &Classes,
    ) -> Option<Element<'n, 'd>> {
        let element = classes.of_tag(node, "equality", self);
        let is_off = self.word(&element, "active", &["true", "false"]) == Some(1);
        (!is_off).then_some(element)
    }

    fn closing(
        &mut self,
        element: &Element<'_, '_>,
        number: usize,
        (bodies, poses): (&[Body], &[Pose]),
    ) -> Option<Closing> {
        let node = element.node;
        let is_weld = node.tag_name().name() == "weld";
        let own = if is_weld { &WELD[..] } else { &[] };
        self.check_names(element, &[&EQUALITY, &CONNECT, own]);
        let sites = "places are written by `body1`, `body2` and `anchor`";
        self.refuse(element, &[("site1", &[], sites), ("site2", &[], sites)]);
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
        if !is_weld {
            self.attribute(node, "anchor")?;
        }
        let anchor = self.triple(element, "anchor", "0 0 0");
        let anchor = anchor.map(|part| part.value());
        // the anchor of a weld is fixed in the second body, and that of a connection in the first
        let (origin, turned) = if is_weld { two } else { one };
        let from = rotate(turned, anchor);
        let place = [0, 1, 2].map(|part| origin[part] + from[part]);
        let mut points = [of(one, place), of(two, place)];
        let mut turned = is_weld.then(|| product(inverse(one.1), two.1));
        if let Some((place, relative)) = self.relative(element).filter(|_| is_weld) {
            points = [place, anchor];
            turned = Some(relative);
        }
        let held = self.single(element, "torquescale", "1");
        if held.is_negative() && !held.is_zero() {
            return self.report(node, "`torquescale` is at least 0");
        }
        // without torque, a weld holds only its anchor
        let turned = turned.filter(|_| !held.is_zero());
        let word = node.attribute("name");
        let word = word.map_or_else(|| format!("closing_{}", number + 1), str::to_owned);
        Some(Closing {
            name: word,
            bodies: [first, second],
            points,
            turned,
            extent: self.at(node),
        })
    }

    /// The place of the anchor in the first body, and the rotation of the second body relative to
    /// the first; `None` for those of the drawn pose, which a rotation of zeros stands for.
    fn relative(&mut self, element: &Element<'_, '_>) -> Option<Pose> {
        let all = self.list(element, "relpose", 7..=7, "0 0 0 0 0 0 0");
        let is_drawn = all[3..].iter().all(Decimal::is_zero);
        let value = |part: usize| all[part].value();
        let pose = ([0, 1, 2].map(value), [3, 4, 5, 6].map(value));
        (!is_drawn).then_some(pose)
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
