//! The derivatives in all directions: backwards from each expression or forwards in each direction,
//! whichever takes fewer operations.

use crate::mechanics::variation::{self, Direction, Leaves, Slopes};
use crate::model::{Meaning, Outline, Workspace};
use crate::symbolic::Id;

/// A group of columns: a group of the tangent space, an input, or a parameter.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Column {
    State(usize),
    Input(usize),
    Param(usize),
}

/// If the forward derivatives take more operations than this, the backward ones are not tried. For
/// such systems they take long to derive, and were better for none in the tests and examples.
const LARGE: u32 = 2000;

/// Each group of columns, with a direction for each of its components.
pub type Directions = Vec<(Column, Vec<Direction>)>;

/// The derivatives of the accelerations in each of these directions.
pub type Changes = Vec<(Column, Vec<Vec<Id>>)>;

/// The directions in which one component of an input changes by one.
pub fn of_inputs(outline: &Outline, work: &mut Workspace) -> Directions {
    let inputs = (0..outline.inputs.len()).map(|number| {
        let symbols = components(work, |part| Meaning::Input(number, part)).into_iter();
        let directions = symbols.map(|symbol| Direction::of_symbol(work, Some(symbol)));
        (Column::Input(number), directions.collect())
    });
    inputs.collect()
}

/// The symbols of an input or a parameter, which is a scalar or a vector.
pub fn components(work: &Workspace, meaning: impl Fn(Option<usize>) -> Meaning) -> Vec<Id> {
    let parts = [None, Some(0), Some(1), Some(2)].into_iter();
    let symbols = parts.filter_map(|part| work.symbol_of(meaning(part)));
    symbols.collect()
}

/// The changes of `roots`, passed through `finish`. They are computed together with the
/// `accelerations`, which their cost includes.
pub fn changes(
    work: &mut Workspace,
    roots: &[Id],
    accelerations: &[Id],
    directions: &Directions,
    mut finish: impl FnMut(&mut Workspace, Vec<Id>) -> Vec<Id>,
) -> Changes {
    let mut all = |work: &mut Workspace, along: &dyn Fn(&mut Workspace, &Direction) -> Vec<Id>| {
        let groups = directions.iter().map(|(column, directions)| {
            let changes = directions.iter().map(|direction| {
                let change = along(work, direction);
                finish(work, change)
            });
            (*column, changes.collect())
        });
        let changes = groups.collect::<Changes>();
        multiplied_out(work, accelerations, changes)
    };
    let (leaves, level) = Leaves::with_level_norms(work, roots);
    let forwards = all(work, &|work, direction| {
        variation::changes(work, &level, &leaves, direction)
    });
    let least = cost(work, accelerations, &forwards);
    if least > LARGE {
        return forwards;
    }
    let slopes = roots.iter().map(|root| {
        let (leaves, level) = Leaves::with_level_norms(work, &[*root]);
        Slopes::of_leaves(work, level[0], leaves)
    });
    let slopes: Vec<Slopes> = slopes.collect();
    let backwards = all(work, &|work, direction| {
        let slopes = slopes.iter();
        slopes.map(|slopes| slopes.along(work, direction)).collect()
    });
    if least < cost(work, accelerations, &backwards) {
        forwards
    } else {
        backwards
    }
}

/// The number of operations of the derivatives and the accelerations together.
fn cost(work: &Workspace, accelerations: &[Id], changes: &Changes) -> u32 {
    let entries = changes.iter().flat_map(|(_, changes)| changes.concat());
    let entries: Vec<Id> = accelerations.iter().copied().chain(entries).collect();
    work.graph.late_cost(&entries).total()
}

/// Quadratic accelerations have linear derivatives. These are multiplied out, group by group, where
/// that takes fewer operations.
fn multiplied_out(work: &mut Workspace, accelerations: &[Id], mut changes: Changes) -> Changes {
    let mut least = cost(work, accelerations, &changes);
    for group in 0..changes.len() {
        let mut tried = changes.clone();
        for change in &mut tried[group].1 {
            for entry in change {
                *entry = work.graph.affine(*entry).unwrap_or(*entry);
            }
        }
        if tried == changes {
            continue;
        }
        let cost = cost(work, accelerations, &tried);
        if cost < least {
            (least, changes) = (cost, tried);
        }
    }
    changes
}
