//! `<tendon>`: fixed tendons, which are sums of coordinates, with their springs and dampers.

use roxmltree::Node;

use crate::errors::Extent;
use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;

use super::body::Body;
use super::classes::{Classes, bare};
use super::describe::Writer;
use super::length::{Length, Term};

pub struct Tendon {
    /// The name in the file.
    pub name: String,
    pub length: Length,
    damping: Option<String>,
    /// The stiffness, and the length at rest.
    spring: Option<(String, String)>,
    extent: Extent,
}

pub const KNOWN: [&str; 8] = [
    "name",
    "class",
    "group",
    "stiffness",
    "damping",
    "springlength",
    "frictionloss",
    "armature",
];
/// Attributes that do not affect the motion, since limits are not modeled.
pub const SKIPPED: [&str; 11] = [
    "limited",
    "range",
    "actuatorfrclimited",
    "actuatorfrcrange",
    "solreflimit",
    "solimplimit",
    "solreffriction",
    "solimpfriction",
    "margin",
    "rgba",
    "user",
];

impl Reader<'_> {
    pub fn tendons(
        &mut self,
        node: Node<'_, '_>,
        classes: &Classes,
        bodies: &[Body],
        found: &mut Vec<Tendon>,
    ) {
        for child in self.parts(node, &["fixed"], &[]) {
            let number = found.len() + 1;
            let tendon = self.tendon(child, classes, bodies, number);
            if tendon.is_none() {
                self.lost.extend(child.attribute("name").map(str::to_owned));
            }
            found.extend(tendon);
        }
    }

    fn tendon(
        &mut self,
        node: Node<'_, '_>,
        classes: &Classes,
        bodies: &[Body],
        number: usize,
    ) -> Option<Tendon> {
        let element = classes.of_tag(node, "tendon", self);
        self.check_names(&element, &[&KNOWN, &SKIPPED]);
        let nothing = &["0"];
        let friction = "dry friction is not read: set it to 0, and write it in `drives`";
        let heavy = "the inertia of a tendon is not read: set it to 0";
        self.refuse(
            &element,
            &[
                ("frictionloss", nothing, friction),
                ("armature", nothing, heavy),
            ],
        );
        let length = self.length(node, bodies)?;
        let mut given = |name: &str| self.nonzero(&element, name);
        let (damping, stiffness) = (given("damping"), given("stiffness"));
        let rest = self.list(&element, "springlength", 1..=2, "-1");
        if let [first, second] = rest.as_slice()
            && !first.is_same(second)
            && stiffness.is_some()
        {
            let message =
                "`springlength`: a spring that is slack between two lengths is not read: write one";
            return self.report(node, message);
        }
        let rest = match rest.first() {
            // -1 stands for the length at which the springs of its joints are at rest
            Some(rest) if !rest.is_same(&Decimal::one(rest.extent).negated()) => rest.literal(),
            _ => length.rest().unwrap_or("0".to_owned()),
        };
        let name = node.attribute("name");
        Some(Tendon {
            name: name.map_or_else(|| format!("tendon_{number}"), str::to_owned),
            damping,
            spring: stiffness.map(|stiffness| (stiffness, rest)),
            length,
            extent: self.at(node),
        })
    }

    /// The length of a tendon, as a sum of coordinates.
    fn length(&mut self, node: Node<'_, '_>, bodies: &[Body]) -> Option<Length> {
        let (mut terms, mut joints) = (Vec::new(), Vec::new());
        for part in self.parts(node, &["joint"], &[]) {
            self.check_attributes(part, &["joint", "coef"]);
            let name = self.attribute(part, "joint")?;
            let joint = self.joint_named(part, name, bodies)?;
            self.attribute(part, "coef")?;
            let factor = self.single(&bare(part), "coef", "1");
            if !factor.is_zero() {
                terms.push(Term::new(joint, Some(&factor)));
                joints.push(joint);
            }
        }
        if terms.is_empty() {
            return self.report(node, "it has no `<joint>` that changes its length");
        }
        self.check_free(node, &joints)?;
        Some(Length(terms))
    }

    pub fn tendon_named<'t>(
        &mut self,
        node: Node<'_, '_>,
        name: &str,
        tendons: &'t [Tendon],
    ) -> Option<&'t Tendon> {
        let found = tendons.iter().find(|tendon| tendon.name == name);
        if found.is_none() {
            let names = tendons.iter().map(|tendon| tendon.name.as_str());
            self.no_such::<()>(node, ("tendon", name), names);
        }
        found
    }
}

impl Writer<'_> {
    /// The spring and the damper of a tendon.
    pub fn tendon(&mut self, tendon: &Tendon, word: &proc_macro2::Ident) {
        let (length, extent) = (&tendon.length, tendon.extent);
        if let Some((stiffness, rest)) = &tendon.spring {
            let text = format!("({stiffness}) / 2 * ({} - {rest}).powi(2)", length.text());
            self.potential(&format!("{word}_spring"), &text, extent);
        }
        if let Some(damping) = &tendon.damping {
            let force = format!("(-({damping}) * {})", length.rate());
            self.along(&format!("{word}_damping"), &force, length, extent);
        }
    }
}
