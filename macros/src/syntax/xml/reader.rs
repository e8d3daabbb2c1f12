//! Elements and attributes of a file, and their errors.

use proc_macro2::{Ident, Span};
use roxmltree::Node;

use crate::errors::{Errors, Extent, hint, similar};

use super::decimal::Decimal;
use super::names::Refused;

/// Attributes that are read.
const ATTRIBUTES: [&str; 12] = [
    "name", "type", "link", "value", "xyz", "rpy", "ixx", "iyy", "izz", "ixy", "iyz", "ixz",
];

/// A file that is being read.
pub struct Reader<'e> {
    /// The path as written.
    pub file: &'e str,
    /// The place of the string that names it.
    pub span: Span,
    pub errors: &'e mut Errors,
    /// Where each line begins.
    lines: Vec<usize>,
    /// The part that is being read, such as ``of link `arm` ``.
    pub owner: String,
    /// Elements that have no meaning here, each once.
    pub skipped: Vec<String>,
    /// Names of elements that were reported and could not be read.
    pub lost: Vec<String>,
    /// Whether more such names may exist.
    pub has_lost_names: bool,
}

impl<'e> Reader<'e> {
    pub fn new(file: &'e str, text: &str, span: Span, errors: &'e mut Errors) -> Self {
        let breaks = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Self {
            file,
            span,
            errors,
            lines: breaks.map(|(place, _)| place + 1).collect(),
            owner: String::new(),
            skipped: Vec::new(),
            lost: Vec::new(),
            has_lost_names: false,
        }
    }

    /// The line of an element.
    pub fn line(&self, node: Node<'_, '_>) -> usize {
        let start = node.range().start;
        1 + self.lines.partition_point(|line| *line <= start)
    }

    /// The place for errors about an element, with the words that they begin with.
    pub fn at(&mut self, node: Node<'_, '_>) -> Extent {
        let (file, line) = (self.file, self.line(node));
        let (tag, owner) = (node.tag_name().name(), &self.owner);
        let words = format!("{file}:{line}, `<{tag}>`{owner}");
        Extent::from(self.span).within(self.errors.source(words))
    }

    pub fn report<T>(&mut self, node: Node<'_, '_>, message: impl core::fmt::Display) -> Option<T> {
        let place = self.at(node);
        self.errors.report(place, message)
    }

    /// Reports an unknown name, unless it may belong to an element that was already reported.
    pub fn no_such<'n, T>(
        &mut self,
        node: Node<'_, '_>,
        (what, name): (&str, &str),
        known: impl IntoIterator<Item = &'n str>,
    ) -> Option<T> {
        if self.has_lost_names || self.lost.iter().any(|lost| lost == name) {
            return None;
        }
        let hint = hint(name, known);
        self.report(node, format!("there is no {what} `{name}`{hint}"))
    }

    /// All elements in `node` with a tag in `known`. Any other element is reported as misspelt, or
    /// is skipped and listed.
    pub fn children<'n, 'd>(
        &mut self,
        node: Node<'n, 'd>,
        known: &[&str],
        skipped: &[&str],
    ) -> Vec<Node<'n, 'd>> {
        let mut found = Vec::new();
        for child in node.children().filter(Node::is_element) {
            let tag = child.tag_name();
            let name = tag.name();
            if tag.namespace().is_some_and(|space| space.contains("xacro")) {
                let message = "this is an element of xacro: expand it first, by `xacro robot.urdf.xacro > robot.urdf`";
                self.report::<()>(child, message);
            } else if known.contains(&name) {
                found.push(child);
            } else if skipped.contains(&name) {
                self.skip(name);
            } else if ["link", "joint"].contains(&name) {
                let message =
                    "this belongs in `<robot>`, beside the links and joints, and not in one";
                self.has_lost_names = true;
                self.report::<()>(child, message);
            } else if let Some(meant) = similar(name, known.iter().copied()) {
                let message = format!("there is no such element; did you mean `<{meant}>`?");
                self.report::<()>(child, message);
            } else {
                self.skip(name);
            }
        }
        found
    }

    /// Notes an element that has no meaning here.
    pub fn skip(&mut self, tag: &str) {
        if !self.skipped.iter().any(|other| other == tag) {
            self.skipped.push(tag.to_owned());
        }
    }

    /// The element with this tag; if there are several, the first one.
    pub fn one<'n, 'd>(&mut self, all: &[Node<'n, 'd>], name: &str) -> Option<Node<'n, 'd>> {
        let mut found = all.iter().filter(|node| node.tag_name().name() == name);
        let first = found.next().copied();
        if let Some(second) = found.next() {
            self.report::<()>(*second, "this is there twice: leave one out");
        }
        first
    }

    /// A required attribute.
    pub fn attribute<'n>(&mut self, node: Node<'n, '_>, name: &str) -> Option<&'n str> {
        let found = node.attribute(name);
        // if it is misspelt, that is already reported
        let is_misspelt = node.attributes().any(|other| {
            !ATTRIBUTES.contains(&other.name()) && similar(other.name(), [name]).is_some()
        });
        if found.is_none() && !is_misspelt {
            self.report::<()>(node, format!("it has no attribute `{name}`"));
        }
        found
    }

    /// Reports attributes that an element does not have.
    pub fn check_attributes(&mut self, node: Node<'_, '_>, known: &[&str]) {
        let unknown = node.attributes().map(|attribute| attribute.name());
        let unknown: Vec<&str> = unknown.filter(|name| !known.contains(name)).collect();
        for name in unknown {
            let hint = hint(name, known.iter().copied());
            self.report::<()>(node, format!("there is no attribute `{name}`{hint}"));
        }
    }

    /// The number in a required attribute.
    pub fn number(&mut self, node: Node<'_, '_>, name: &str) -> Option<Decimal> {
        let text = self.attribute(node, name)?;
        self.decimal(node, name, text.trim())
    }

    pub fn decimal(&mut self, node: Node<'_, '_>, name: &str, text: &str) -> Option<Decimal> {
        let extent = self.at(node);
        let found = Decimal::parse(text, extent);
        if found.is_none() {
            let shown: String = text.chars().take(40).collect();
            let message = format!("`{name}` is a decimal number, and this is `{shown}`");
            self.errors.push(extent, message);
        }
        let found = found?;
        if found.value().is_infinite() {
            let message =
                format!("`{text}` is out of the range of `f64`, which is about 5e-324 to 1.8e308");
            return self.errors.report(extent, message);
        }
        Some(found)
    }

    /// The three numbers in an attribute; zeros if it is missing.
    pub fn three(&mut self, node: Node<'_, '_>, name: &str) -> Option<[Decimal; 3]> {
        let extent = self.at(node);
        let Some(text) = node.attribute(name) else {
            return Some([0, 1, 2].map(|_| Decimal::zero(extent)));
        };
        let parts: Vec<&str> = text.split_whitespace().collect();
        let [x, y, z] = parts.as_slice() else {
            let count = parts.len();
            let message =
                format!("`{name}` has three numbers with blanks between, and this has {count}");
            return self.report(node, message);
        };
        let all = [x, y, z].map(|part| self.decimal(node, name, part));
        let [Some(x), Some(y), Some(z)] = all else {
            return None;
        };
        Some([x, y, z])
    }

    /// The name of a link or a joint, as it is used here and as it stands in the file.
    pub fn named<'n>(
        &mut self,
        node: Node<'n, '_>,
        take: impl FnOnce(&str, Span) -> Result<Ident, Refused>,
    ) -> Option<(Ident, &'n str)> {
        self.owner.clear();
        let name = self.attribute(node, "name")?;
        self.given(node, name, take).map(|ident| (ident, name))
    }

    /// A name as it is used here. One that cannot be used is reported, and replaced by another.
    pub fn take(
        &mut self,
        node: Node<'_, '_>,
        name: &str,
        take: impl FnOnce(&str, Span) -> Result<Ident, Refused>,
    ) -> Ident {
        let found = self.given(node, name, take);
        found.unwrap_or_else(|| Ident::new("unnamed", self.span))
    }

    fn given(
        &mut self,
        node: Node<'_, '_>,
        name: &str,
        take: impl FnOnce(&str, Span) -> Result<Ident, Refused>,
    ) -> Option<Ident> {
        match take(name, self.span) {
            Ok(ident) => Some(ident),
            Err(Refused::Empty) => self.report(
                node,
                format!("`{name}` is no name: it has no letter and no digit of ASCII"),
            ),
            Err(Refused::Taken(word)) => {
                // one of the two may have been meant to have another name
                self.has_lost_names = true;
                let becomes = if word == name {
                    String::new()
                } else {
                    format!(", as `{name}` is written here,")
                };
                self.report(node, format!("the name `{word}`{becomes} is taken already"))
            }
        }
    }
}
