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

/// `<default class="..">`, by name.
#[derive(Default)]
pub struct Classes(BTreeMap<String, Class>);

/// What a class gives to its elements.
#[derive(Clone, Default)]
struct Class {
    /// Attributes by tag, including those of the enclosing classes.
    tags: BTreeMap<String, Attributes>,
    /// The tags and attributes of its actuators, after those of each enclosing class.
    actuators: Vec<Vec<(String, Attributes)>>,
}

/// The actuators of classes that an actuator follows, class by class, and the actuator itself.
pub type Steps<'n, 'd> = Vec<Vec<(String, Element<'n, 'd>)>>;

/// The class of elements that name none.
const MAIN: &str = "main";
/// Rotations of a body or a geom. One that is written replaces any other that a class gives.
pub const TURNS: [&str; 5] = ["quat", "axisangle", "euler", "xyaxes", "zaxis"];
/// Lists that may be shorter than those of the class, which give the numbers that are missing.
const FILLED: [&str; 4] = ["size", "gear", "damping", "stiffness"];
/// Elements of classes that do not affect the motion.
const SKIPPED: [&str; 7] = [
    "mesh", "texture", "material", "site", "camera", "light", "pair",
];
/// The tags that a class may contain.
pub struct Tags<'t> {
    /// The supported ones, each with its known attributes.
    pub known: &'t [(&'t str, &'t [&'t [&'t str]])],
    /// All kinds of actuators, also those that are not read.
    pub actuators: &'t [&'t str],
}

impl Classes {
    /// Reads a `<default>` and those inside it.
    pub fn read(&mut self, root: Node<'_, '_>, all: &Tags<'_>, reader: &mut Reader<'_>) {
        let mut expected: Vec<&str> = all.known.iter().map(|(tag, _)| *tag).collect();
        expected.extend(all.actuators);
        expected.push("default");
        let mut pending = vec![(root, None::<String>)];
        while let Some((node, around)) = pending.pop() {
            let class = match (node.attribute("class"), &around) {
                (Some(class), None) if class != MAIN => {
                    let message = format!("the outermost class is `{MAIN}`, and this is `{class}`");
                    reader.report::<()>(node, message);
                    continue;
                }
                (Some(class), _) => class.to_owned(),
                (None, None) => MAIN.to_owned(),
                (None, Some(_)) => {
                    reader.report::<()>(node, "it has no attribute `class`");
                    continue;
                }
            };
            let around = around.and_then(|around| self.0.get(&around).cloned());
            let known = self.0.get(&class).cloned();
            let mut given = known.or(around).unwrap_or_default();
            let mut actuators = Vec::new();
            for child in reader.parts(node, &expected, &SKIPPED) {
                let tag = child.tag_name().name();
                if tag == "default" {
                    pending.push((child, Some(class.clone())));
                    continue;
                }
                if let Some((_, names)) = all.known.iter().find(|(known, _)| *known == tag) {
                    reader.check_attributes(child, &names.concat());
                }
                let own = attributes(child);
                if all.actuators.contains(&tag) {
                    actuators.push((tag.to_owned(), own));
                } else {
                    overlay(given.tags.entry(tag.to_owned()).or_default(), &own);
                }
            }
            given.actuators.push(actuators);
            self.0.insert(class, given);
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

    /// An actuator with the attributes that its classes give to actuators of any kind, and the steps
    /// to what it does.
    pub fn actuator<'n, 'd>(
        &self,
        node: Node<'n, 'd>,
        reader: &mut Reader<'_>,
    ) -> (Element<'n, 'd>, Steps<'n, 'd>) {
        let class = self.class(node, None, reader);
        let mut steps = class.map_or_else(Vec::new, |class| class.actuators.clone());
        steps.push(vec![(node.tag_name().name().to_owned(), attributes(node))]);
        let mut all = Attributes::new();
        let written = steps.iter().flatten();
        written.for_each(|(_, attributes)| overlay(&mut all, attributes));
        let element = |attributes: Attributes| Element { node, attributes };
        let step = |(tag, attributes)| (tag, element(attributes));
        let steps = steps.into_iter();
        let steps = steps.map(|class| class.into_iter().map(step).collect());
        (element(all), steps.collect())
    }

    fn of_class<'n, 'd>(
        &self,
        node: Node<'n, 'd>,
        (around, tag): (Option<&str>, &str),
        reader: &mut Reader<'_>,
    ) -> Element<'n, 'd> {
        let class = self.class(node, around, reader);
        let known = class.and_then(|class| class.tags.get(tag));
        let mut all = known.cloned().unwrap_or_default();
        overlay(&mut all, &attributes(node));
        Element {
            node,
            attributes: all,
        }
    }

    /// The class of an element. Reports a class that does not exist.
    fn class(
        &self,
        node: Node<'_, '_>,
        around: Option<&str>,
        reader: &mut Reader<'_>,
    ) -> Option<&Class> {
        let class = node.attribute("class");
        let found = self.0.get(class.or(around).unwrap_or(MAIN));
        if let Some(class) = class.filter(|_| found.is_none()) {
            let hint = hint(class, self.0.keys().map(String::as_str));
            reader.report::<()>(node, format!("there is no class `{class}`{hint}"));
        }
        found
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
    Element {
        node,
        attributes: attributes(node),
    }
}

fn attributes(node: Node<'_, '_>) -> Attributes {
    let owned = |text: &str| text.to_owned();
    let all = node.attributes();
    all.map(|one| (owned(one.name()), owned(one.value())))
        .collect()
}

/// Writes the attributes of an element over those of its class.
fn overlay(into: &mut Attributes, from: &Attributes) {
    if TURNS.iter().any(|name| from.contains_key(*name)) {
        into.retain(|name, _| !TURNS.contains(&name.as_str()));
    }
    for (name, value) in from {
        let mut value = value.clone();
        if let Some(around) = into.get(name).filter(|_| FILLED.contains(&name.as_str())) {
            let count = value.split_whitespace().count();
            let missing = around.split_whitespace().skip(count);
            value.extend(missing.flat_map(|part| [" ", part]));
        }
        into.insert(name.clone(), value);
    }
}

/// Whether a text has only this word; numbers are compared by their values.
fn says_only(text: &str, word: &str) -> bool {
    let number = |text: &str| text.parse::<f64>().ok();
    let is_same =
        |part: &str| part == word || number(part).is_some_and(|value| number(word) == Some(value));
    text.split_whitespace().all(is_same)
}

impl Reader<'_> {
    /// The numbers of an attribute. If there are fewer than in the default, the default gives the
    /// rest. Default numbers replace an attribute that is missing, or is wrong and reported.
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
        let rest = default.split_whitespace().skip(found.len());
        if count.contains(&found.len()) {
            let all = found.iter().copied().chain(rest);
            let all = all.map(|text| self.decimal(element.node, name, text));
            let all: Vec<Option<Decimal>> = all.collect();
            if let Some(all) = all.into_iter().collect::<Option<Vec<_>>>() {
                return all;
            }
        } else {
            let expected = match (least, most) {
                (1, 1) => "is one number".to_owned(),
                _ if least == most => format!("has {least} numbers with blanks between"),
                _ => format!("has {least} to {most} numbers with blanks between"),
            };
            let message = format!("`{name}` {expected}, and this has {}", found.len());
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
    /// values. Each number of a list is compared with a neutral number.
    pub fn refuse(&mut self, element: &Element<'_, '_>, all: &[(&str, &[&str], &str)]) {
        for (name, nothing, why) in all {
            let Some(text) = element.get(name) else {
                continue;
            };
            let is_neutral = nothing.iter().any(|word| says_only(text, word));
            if !is_neutral && !text.trim().is_empty() {
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
