//! The sizes of the vectors in a description: two components in the plane, three in space.

use crate::families::LoadKind;

use super::Description;
use super::expression::{Expression, Kind};

impl Description {
    /// All values of its points, locals, forces, potentials and constraints. Moments in the plane
    /// are numbers, and may be written as vectors by mistake.
    pub fn values(&self) -> impl Iterator<Item = &Expression> {
        let forces = self
            .loads
            .iter()
            .filter(|load| load.kind == LoadKind::Force);
        let loads = forces.filter_map(|load| load.vector.as_ref());
        let definitions = self.points.iter().chain(&self.locals);
        let definitions = definitions.chain(&self.potentials).chain(&self.constraints);
        loads.chain(definitions.filter_map(|definition| definition.value.as_ref()))
    }

    /// Whether most of its vectors have components in the plane, or in space.
    pub fn shows(&self, is_planar: bool) -> bool {
        most_are(self.values(), is_planar)
    }
}

/// The functions that take one number for each axis.
const VECTORS: [&str; 3] = ["world", "body", "principal"];

/// Whether most vectors in these expressions have components in the plane, or in space.
pub fn most_are<'e>(written: impl Iterator<Item = &'e Expression>, is_planar: bool) -> bool {
    let (mut in_plane, mut in_space) = (0, 0);
    for expression in written {
        expression.visit(|part| {
            let count = match &part.kind {
                Kind::Tuple(parts) => parts.len(),
                Kind::Call(word, parts) if VECTORS.iter().any(|known| word == known) => parts.len(),
                _ => 0,
            };
            in_plane += usize::from(count == 2);
            in_space += usize::from(count == 3);
        });
    }
    if is_planar {
        in_plane > in_space
    } else {
        in_space > in_plane
    }
}
