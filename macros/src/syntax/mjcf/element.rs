//! Elements, with the attributes that their classes give them.

use core::ops::RangeInclusive;
use std::collections::BTreeMap;

use roxmltree::Node;

use crate::errors::hint;
use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;

type Attributes = BTreeMap<String, String>;

/// An element, and its attributes, including those of its class.
pub struct Element<'n, 'd> {
    pub node: Node<'n, 'd>,
    attributes: Attributes,
}

impl Element<'_, '_> {
    pub fn get(&self, name: &str) -> Option<&str> {
        self.attributes.get(name).map(String::as_str)
    }

    pub fn has(&self, name: &str) -> bool {
        self.attributes.contains_key(name)
    }
}

/// `<default class="..">`: attributes by class and tag, including those of the enclosing classes.
#[derive(Default)]
pub struct Classes(BTreeMap<String, BTreeMap<String, Attributes>>);

/// The class of elements that name none.
const MAIN: &str = "main";
/// The tags that a class may contain, and the supported attributes of each.
const TAGS: [&str; 8] = [
    "joint", "geom", "motor", "position", "velocity", "damper", "general", "tendon",
];

impl Classes {
    /// Reads a `<default>` and those inside it.
    pub fn read(&mut self, root: Node<'_, '_>, reader: &mut Reader<'_>) {
        let mut pending = vec![(root, None::<String>)];
        while let Some((node, around)) = pending.pop() {
            let class = match (node.attribute("class"), &around) {
                (Some(class), _) => class.to_owned(),
                (None, None) => MAIN.to_owned(),
                (None, Some(_)) => {
                    reader.report::<()>(node, "it has no attribute `class`");
                    continue;
                }
            };
            let around = around.and_then(|around| self.0.get(&around).cloned());
            let known = self.0.get(&class).cloned();
            let mut tags = known.or(around).unwrap_or_default();
            for child in node.children().filter(Node::is_element) {
                let tag = child.tag_name().name();
                if tag == "default" {
                    pending.push((child, Some(class.clone())));
                } else if TAGS.contains(&tag) {
                    let into = tags.entry(tag.to_owned()).or_default();
                    overlay(into, child);
                }
            }
            self.0.insert(class, tags);
        }
    }

    /// An element with the attributes of its class, or of the class of the body around it.
    pub fn of<'n, 'd>(
        &self,
        node: Node<'n, 'd>,
        around: Option<&str>,
        reader: &mut Reader<'_>,
    ) -> Element<'n, 'd> {
        self.of_class(node, (around, node.tag_name().name()), reader)
    }

    /// The same for an element whose attributes classes list under another tag.
    pub fn of_tag<'n, 'd>(
        &self,
        node: Node<'n, 'd>,
        tag: &str,
        reader: &mut Reader<'_>,
    ) -> Element<'n, 'd> {
        self.of_class(node, (None, tag), reader)
    }

    /// The attributes that the class of an element gives to another tag.
    pub fn given(&self, node: Node<'_, '_>, tag: &str) -> Vec<&str> {
        let class = node.attribute("class").unwrap_or(MAIN);
        let known = self.0.get(class).and_then(|tags| tags.get(tag));
        let known = known.into_iter().flat_map(Attributes::keys);
        known.map(String::as_str).collect()
    }

    fn of_class<'n, 'd>(
        &self,
        node: Node<'n, 'd>,
        (around, tag): (Option<&str>, &str),
        reader: &mut Reader<'_>,
    ) -> Element<'n, 'd> {
        let class = node.attribute("class");
        let used = class.or(around).unwrap_or(MAIN);
        let tags = self.0.get(used);
        if let Some(class) = class.filter(|_| tags.is_none()) {
            let hint = hint(class, self.0.keys().map(String::as_str));
            reader.report::<()>(node, format!("there is no class `{class}`{hint}"));
        }
        let known = tags.and_then(|tags| tags.get(tag));
        let mut attributes = known.cloned().unwrap_or_default();
        overlay(&mut attributes, node);
        Element { node, attributes }
    }

    pub fn check_class(&self, node: Node<'_, '_>, reader: &mut Reader<'_>) {
        if let Some(class) = node.attribute("childclass")
            && !self.0.contains_key(class)
        {
            let hint = hint(class, self.0.keys().map(String::as_str));
            reader.report::<()>(node, format!("there is no class `{class}`{hint}"));
        }
    }
}

/// An element that has no class.
pub fn bare<'n, 'd>(node: Node<'n, 'd>) -> Element<'n, 'd> {
    let mut attributes = Attributes::new();
    overlay(&mut attributes, node);
    Element { node, attributes }
}

fn overlay(into: &mut Attributes, node: Node<'_, '_>) {
    for attribute in node.attributes() {
        into.insert(attribute.name().to_owned(), attribute.value().to_owned());
    }
}

impl Reader<'_> {
    /// The numbers of an attribute. Default numbers replace an attribute that is missing, or is
    /// wrong and reported.
    pub fn list(
        &mut self,
        element: &Element<'_, '_>,
        name: &str,
        count: RangeInclusive<usize>,
        default: &str,
    ) -> Vec<Decimal> {
        let text = element.get(name).unwrap_or(default);
        let found: Vec<&str> = text.split_whitespace().collect();
        let (least, most) = (*count.start(), *count.end());
        if count.contains(&found.len()) {
            let all = found
                .iter()
                .map(|text| self.decimal(element.node, name, text));
            let all: Vec<Option<Decimal>> = all.collect();
            if let Some(all) = all.into_iter().collect::<Option<Vec<_>>>() {
                return all;
            }
        } else {
            let expected = if least == most {
                format!("{least}")
            } else {
                format!("{least} to {most}")
            };
            let message = format!(
                "`{name}` has {expected} numbers with blanks between, and this has {}",
                found.len()
            );
            self.report::<()>(element.node, message);
        }
        let extent = self.at(element.node);
        let parts = default.split_whitespace();
        parts
            .filter_map(|text| Decimal::parse(text, extent))
            .collect()
    }

    pub fn triple(&mut self, element: &Element<'_, '_>, name: &str, default: &str) -> [Decimal; 3] {
        let extent = self.at(element.node);
        let found = self.list(element, name, 3..=3, default);
        <[Decimal; 3]>::try_from(found).unwrap_or([0, 1, 2].map(|_| Decimal::zero(extent)))
    }

    /// One number.
    pub fn single(&mut self, element: &Element<'_, '_>, name: &str, default: &str) -> Decimal {
        let extent = self.at(element.node);
        let found = self.list(element, name, 1..=1, default);
        found.into_iter().next().unwrap_or(Decimal::zero(extent))
    }

    /// One number as text, unless it is zero.
    pub fn nonzero(&mut self, element: &Element<'_, '_>, name: &str) -> Option<String> {
        let value = self.single(element, name, "0");
        (!value.is_zero()).then(|| value.literal())
    }

    /// The elements in `node` with tags in `known`. Reports elements that are neither known nor
    /// among `skipped`, because they would change the motion.
    pub fn parts<'n, 'd>(
        &mut self,
        node: Node<'n, 'd>,
        known: &[&str],
        skipped: &[&str],
    ) -> Vec<Node<'n, 'd>> {
        let mut found = Vec::new();
        for child in node.children().filter(Node::is_element) {
            let tag = child.tag_name().name();
            if known.contains(&tag) {
                found.push(child);
            } else if skipped.contains(&tag) {
                self.skip(tag);
            } else if [
                "include",
                "frame",
                "replicate",
                "attach",
                "composite",
                "flexcomp",
            ]
            .contains(&tag)
            {
                let message = "this stands for other elements: let MuJoCo write them out, by `mj_saveLastXML`";
                self.has_lost_names = true;
                self.report::<()>(child, message);
            } else {
                let hint = hint(tag, known.iter().copied());
                self.lost.extend(child.attribute("name").map(str::to_owned));
                self.report::<()>(
                    child,
                    format!("this is not read, and may change the motion{hint}"),
                );
            }
        }
        found
    }

    /// Rejects attributes that would change the motion, unless they have one of their neutral
    /// values.
    pub fn refuse(&mut self, element: &Element<'_, '_>, all: &[(&str, &[&str], &str)]) {
        for (name, nothing, why) in all {
            let Some(text) = element.get(name) else {
                continue;
            };
            let says = text.split_whitespace().any(|part| {
                let is_zero = part.parse().is_ok_and(|value: f64| value == 0.0);
                !(nothing.contains(&part) || is_zero && nothing.contains(&"0"))
            });
            if says {
                self.report::<()>(element.node, format!("`{name}`: {why}"));
            }
        }
    }

    /// Reports attributes that an element does not have. Those of its class are checked in the
    /// class.
    pub fn check_names(&mut self, element: &Element<'_, '_>, known: &[&[&str]]) {
        let known: Vec<&str> = known.concat();
        self.check_attributes(element.node, &known);
    }
}
