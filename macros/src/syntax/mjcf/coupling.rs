//! `<equality>` between coordinates: joints and tendons that follow others.

use roxmltree::Node;

use crate::errors::Extent;
use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;

use super::body::Body;
use super::classes::{Classes, Element};
use super::describe::Writer;
use super::equality::EQUALITY;
use super::length::{Length, Term};
use super::tendon::Tendon;

/// The first length is a polynomial of the second, both measured from the drawn pose.
pub struct Coupling {
    pub name: String,
    first: Length,
    second: Option<Length>,
    polynomial: Vec<Decimal>,
    extent: Extent,
}

const KNOWN: [&str; 5] = ["joint1", "joint2", "tendon1", "tendon2", "polycoef"];

impl Reader<'_> {
    pub fn couplings(
        &mut self,
        node: Node<'_, '_>,
        classes: &Classes,
        (bodies, tendons): (&[Body], &[Tendon]),
        found: &mut Vec<Coupling>,
    ) {
        for node in node.children() {
            if ["joint", "tendon"].contains(&node.tag_name().name())
                && let Some(element) = self.active(node, classes)
            {
                let number = found.len() + 1;
                found.extend(self.coupling(&element, number, (bodies, tendons)));
            }
        }
    }

    fn coupling(
        &mut self,
        element: &Element<'_, '_>,
        number: usize,
        (bodies, tendons): (&[Body], &[Tendon]),
    ) -> Option<Coupling> {
        let node = element.node;
        self.check_names(element, &[&EQUALITY, &KNOWN]);
        let tag = node.tag_name().name();
        let [first, second] = [1, 2].map(|end| format!("{tag}{end}"));
        let first = self.attribute(node, &first)?.to_owned();
        let names = [Some(first.as_str()), element.get(&second)];
        let names = names.into_iter().flatten();
        let mut lengths = Vec::new();
        if tag == "joint" {
            let joints = names.map(|name| self.joint_named(node, name, bodies));
            let joints: Vec<_> = joints.collect::<Option<_>>()?;
            self.check_free(node, &joints)?;
            lengths.extend(
                joints
                    .iter()
                    .map(|joint| Length(vec![Term::new(joint, None)])),
            );
        } else {
            for name in names {
                lengths.push(self.tendon_named(node, name, tendons)?.length.clone());
            }
        }
        let polynomial = self.list(element, "polycoef", 1..=5, "0 1 0 0 0");
        let name = node.attribute("name");
        let mut lengths = lengths.into_iter();
        Some(Coupling {
            name: name.map_or_else(|| format!("coupling_{number}"), str::to_owned),
            first: lengths.next()?,
            second: lengths.next(),
            polynomial,
            extent: self.at(node),
        })
    }
}

impl Writer<'_> {
    /// `first - (a + b * second + c * second.powi(2))`
    pub fn couple(&mut self, coupling: &Coupling, word: &proc_macro2::Ident) {
        let other = coupling.second.as_ref().map(Length::change);
        // without a factor, the second length keeps its unit
        let second = coupling.second.as_ref();
        let is_alike = second.is_some_and(|second| second.kind() == coupling.first.kind());
        let terms = coupling.polynomial.iter().enumerate();
        let terms = terms.filter(|(_, factor)| !factor.is_zero());
        let terms = terms.filter_map(|(power, factor)| {
            let factor = factor.literal();
            match (power, &other) {
                (0, _) => Some(format!("({factor})")),
                (_, None) => None,
                (1, Some(other)) if factor == "1" && is_alike => Some(other.clone()),
                (1, Some(other)) => Some(format!("({factor}) * {other}")),
                (_, Some(other)) => Some(format!("({factor}) * ({other}).powi({power})")),
            }
        });
        let terms: Vec<String> = terms.collect();
        let first = coupling.first.change();
        let text = match terms.as_slice() {
            [] => first,
            [one] => format!("{first} - {one}"),
            all => format!("{first} - ({})", all.join(" + ")),
        };
        self.constraint(word, &text, coupling.extent);
    }
}
