//! Folds statements that are used only once, where that saves operations on constants.

use crate::symbolic::graph::{Graph, Id, Node};

impl Graph {
    /// `roots` without the statements `early * late` and `early + late` that are used only once,
    /// and the images of all their late parts, in order. Without a saving, `roots` are unchanged and
    /// there are no images.
    pub fn folded(&mut self, roots: &[Id]) -> (Vec<Id>, Vec<(Id, Id)>) {
        let last = roots.iter().max().map_or(0, |last| last.index());
        let mut uses = vec![0_u32; last + 1];
        let order = self.reachable(roots, &|id| !self.is_early(id));
        for id in &order {
            for operand in self.node(*id).operands() {
                uses[operand.index()] += 1;
            }
        }
        for root in roots {
            uses[root.index()] += 1;
        }
        let images = self.images(&order, |graph, id, image| match *graph.node(id) {
            Node::Quantity(inner) if uses[id.index()] == 1 && graph.has_early_part(inner) => {
                if graph.is_early(id) {
                    inner
                } else {
                    image(inner)
                }
            }
            _ if graph.is_early(id) => id,
            _ => graph.remake(id, image),
        });
        let image = |id: &Id| images[id.index()];
        let folded: Vec<Id> = roots.iter().map(image).collect();
        let cost = |roots: &[Id]| self.late_cost(roots).total();
        if cost(&folded) < cost(roots) {
            let mut images: Vec<(Id, Id)> = order.iter().map(|id| (*id, image(id))).collect();
            // negatives may have names, though sums contain what is negated
            for (id, image) in images.clone() {
                if let Some(negative) = self.negation_of(id) {
                    images.push((negative, self.negate(image)));
                }
            }
            (folded, images)
        } else {
            (roots.to_vec(), Vec::new())
        }
    }

    fn has_early_part(&self, id: Id) -> bool {
        let mut operands = self.node(id).operands();
        matches!(
            self.node(id),
            Node::Add(..) | Node::Subtract(..) | Node::Multiply(..)
        ) && operands.any(|operand| self.is_early(operand))
    }
}
