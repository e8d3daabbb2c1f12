//! `<mimic>`: a joint whose coordinate follows that of another one.

use roxmltree::Node;

use crate::errors::Extent;
use crate::syntax::xml::decimal::Decimal;
use crate::syntax::xml::reader::Reader;

/// `multiplier * leader + offset`
pub struct Mimic {
    /// The name of the joint in the file.
    pub leader: String,
    pub multiplier: Decimal,
    pub offset: Decimal,
    pub extent: Extent,
}

impl Reader<'_> {
    pub fn mimic(&mut self, node: Node<'_, '_>) -> Option<Mimic> {
        self.check_attributes(node, &["joint", "multiplier", "offset"]);
        let extent = self.at(node);
        let leader = self.attribute(node, "joint")?.to_owned();
        let mut number = |name: &str, default: Decimal| match node.attribute(name) {
            Some(text) => self.decimal(node, name, text.trim()),
            None => Some(default),
        };
        let multiplier = number("multiplier", Decimal::one(extent));
        let offset = number("offset", Decimal::zero(extent));
        Some(Mimic {
            leader,
            multiplier: multiplier?,
            offset: offset?,
            extent,
        })
    }
}
