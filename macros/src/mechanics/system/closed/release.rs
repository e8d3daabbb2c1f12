//! Changes after which all loads of an overconstrained system are determined: joints of less
//! restrictive kinds, links that are left out, and, if these are not enough, directions to release.
//!
//! A released direction carries no load. Take the parts of the self-balancing loads along the
//! released directions. If they are independent, and as many as these loads, then none of these
//! loads remains, and the motion is unchanged.

use std::iter;

use crate::mechanics::proofs::samples;
use crate::model::{AXES, System, TreeJoint, Workspace};
use crate::symbolic::{Components, Graph, Id, Residue, Span};

use super::undetermined::{Spare, Undetermined};

/// The most joints that are tried together.
const MOST_JOINTS: usize = 3;
/// The most ways to release that are tried.
const FEW: usize = 60;

/// A way to release, and the directions that it releases. It has as many rows as directions, or
/// more if some are equivalent; each row is the part of all spare loads along one direction.
struct Way<T> {
    holder: usize,
    said: String,
    count: usize,
    rows: Vec<Vec<T>>,
}

/// The directions that a joint no longer holds if its kind is changed.
#[derive(Clone, Copy)]
enum Free {
    ForceAlong,
    MomentAlong,
    Moment,
}

/// The less restrictive kinds of joints, each with the number of released directions.
fn instead(kind: &str, is_planar: bool) -> &'static [(&'static str, Free, usize)] {
    match (kind, is_planar) {
        ("revolute", false) => &[
            ("spherical", Free::Moment, 2),
            ("cylindrical", Free::ForceAlong, 1),
        ],
        ("prismatic", false) => &[("cylindrical", Free::MomentAlong, 1)],
        ("prismatic", true) => &[("pin_in_slot", Free::Moment, 1)],
        ("screw", false) => &[("cylindrical", Free::ForceAlong, 1)],
        ("universal", false) => &[("spherical", Free::Moment, 1)],
        ("weld", false) => &[("spherical", Free::Moment, 3)],
        ("weld", true) => &[("revolute", Free::Moment, 1)],
        _ => &[],
    }
}

/// Ways to release after which all loads are determined, in words, such as ``with `a` as
/// `spherical` ``. If there would be many, whole joints are left out instead.
pub fn release(system: &System, work: &mut Workspace, undetermined: &Undetermined) -> String {
    let spare = &undetermined.spare;
    let ways = sampled(work, |graph| ways(graph, system, undetermined));
    let chosen = fewest(&ways, spare.len()).unwrap_or_else(|| {
        let single = sampled(work, |graph| components(graph, system, spare));
        let singly = one_by_one(&ways, &single);
        if singly.len() <= MOST_JOINTS {
            return singly;
        }
        let joints = sampled(work, |_| without_joints(system, undetermined));
        fewest(&joints, spare.len()).unwrap_or(singly)
    });
    chosen.join(" and ")
}

/// The fewest ways, at different joints, that together remove this many spare loads.
fn fewest(ways: &[Way<Residue>], wanted: usize) -> Option<Vec<String>> {
    let (mut span, mut chosen) = (Span::default(), Vec::new());
    let is_found = ways.len() <= FEW
        && (1..=MOST_JOINTS).any(|most| search(ways, (0, most), &mut span, (&mut chosen, wanted)));
    is_found.then(|| chosen.iter().map(|way| ways[*way].said.clone()).collect())
}

/// Each way that releases something more than those before it, followed by single components of
/// other joints.
fn one_by_one(ways: &[Way<Residue>], single: &[Way<Residue>]) -> Vec<String> {
    let (mut span, mut holders, mut said) = (Span::default(), Vec::new(), Vec::new());
    let whole = ways.iter().map(|way| (way, true));
    for (way, is_whole) in whole.chain(single.iter().map(|way| (way, false))) {
        if is_whole && holders.contains(&way.holder) {
            continue;
        }
        if let Some(larger) = with(&span, way) {
            span = larger;
            holders.push(way.holder);
            said.push(way.said.clone());
        }
    }
    said
}

/// The releases by joints of other kinds, and by links that are left out.
fn ways(graph: &mut Graph, system: &System, undetermined: &Undetermined) -> Vec<Way<Id>> {
    let spare = &undetermined.spare;
    let mut ways = Vec::new();
    for (holder, joint) in holders(system).enumerate() {
        let kinds = instead(joint.kind, system.is_planar).iter();
        for (kind, free, count) in kinds.filter(|_| !joint.is_driven) {
            ways.push(Way {
                holder,
                said: format!("with `{}` as `{kind}`", joint.name),
                count: *count,
                rows: rows(graph, spare, holder, (*free, undetermined.axes[holder])),
            });
        }
    }
    let links = system.constraints.list.iter().enumerate();
    for (number, link) in links.filter(|(_, one)| system.is_link(&one.place)) {
        ways.push(Way {
            holder: undetermined.axes.len() + number,
            said: format!("without `{}`", link.name),
            count: 1,
            rows: vec![spare.iter().map(|spare| spare.loads[number]).collect()],
        });
    }
    ways
}

/// The releases by leaving out joints that close loops.
fn without_joints(system: &System, undetermined: &Undetermined) -> Vec<Way<Id>> {
    let closings = system.closings.iter().enumerate();
    let ways = closings.map(|(number, closing)| {
        let holder = system.joints.len() + number;
        let spare = undetermined.spare.iter();
        let wrenches: Vec<Vec<Id>> = spare.map(|spare| spare.wrench(holder).concat()).collect();
        let all = if system.is_planar { 3 } else { 6 };
        let parts = 0..2 * AXES.len();
        let part = |part: usize| wrenches.iter().map(|wrench| wrench[part]).collect();
        Way {
            holder,
            said: format!("without `{}`", closing.name),
            count: all - closing.kind.freedoms(system.is_planar).len(),
            rows: parts.map(part).collect(),
        }
    });
    ways.collect()
}

/// Name and kind of a joint, and whether it is driven.
struct Holder {
    name: String,
    kind: &'static str,
    is_driven: bool,
}

/// The joints of the tree, followed by those that close loops.
fn holders(system: &System) -> impl Iterator<Item = Holder> {
    let driven = system.joints.iter().map(TreeJoint::is_driven);
    let driven = driven.chain(iter::repeat(false));
    let joints = system.connections().zip(driven);
    joints.map(|(joint, is_driven)| Holder {
        name: joint.name.to_string(),
        kind: joint.kind.word,
        is_driven,
    })
}

/// The parts of all spare loads that a joint would release.
fn rows(
    graph: &mut Graph,
    spare: &[Spare],
    holder: usize,
    (free, axis): (Free, Option<Components>),
) -> Vec<Vec<Id>> {
    let wrenches = spare.iter().map(|spare| spare.wrench(holder));
    let along = |graph: &mut Graph, part: usize| {
        let axis = axis.unwrap_or_else(|| graph.zeros());
        let all = wrenches.clone().map(|wrench| graph.dot(axis, wrench[part]));
        vec![all.collect()]
    };
    match free {
        Free::ForceAlong => along(graph, 0),
        Free::MomentAlong => along(graph, 1),
        Free::Moment => {
            let axes = 0..AXES.len();
            axes.map(|axis| wrenches.clone().map(|wrench| wrench[1][axis]).collect())
                .collect()
        }
    }
}

/// Ways that release one component of the load of one joint; joints that close loops come first.
fn components(graph: &Graph, system: &System, spare: &[Spare]) -> Vec<Way<Id>> {
    let mut ways = Vec::new();
    for (holder, joint) in holders(system)
        .enumerate()
        .collect::<Vec<_>>()
        .into_iter()
        .rev()
    {
        for (part, word) in ["force", "moment"].into_iter().enumerate() {
            for (axis, letter) in AXES.into_iter().enumerate() {
                let all = spare.iter().map(|spare| spare.wrench(holder)[part][axis]);
                let row: Vec<Id> = all.collect();
                if row.iter().all(|one| graph.is_zero(*one)) {
                    continue;
                }
                let component = component(&joint.name, (word, letter), system.is_planar);
                ways.push(Way {
                    holder,
                    said: format!("without {component}"),
                    count: 1,
                    rows: vec![row],
                });
            }
        }
    }
    ways
}

/// `` `a.force.x` ``
pub fn component(joint: &str, (part, axis): (&str, &str), is_planar: bool) -> String {
    if is_planar && part == "moment" {
        format!("`{joint}.{part}`")
    } else {
        format!("`{joint}.{part}.{axis}`")
    }
}

/// The ways with the values of their rows at a random state.
fn sampled(
    work: &mut Workspace,
    ways: impl FnOnce(&mut Graph) -> Vec<Way<Id>>,
) -> Vec<Way<Residue>> {
    let ways = ways(&mut work.graph);
    let all: Vec<Id> = ways.iter().flat_map(|way| way.rows.concat()).collect();
    let mut values = samples(work, &all).into_iter();
    let mut next = || {
        let known = values
            .next()
            .and_then(|sample| sample.0.into_iter().flatten().next());
        known.unwrap_or(Residue::ZERO)
    };
    let ways = ways.into_iter().map(|way| Way {
        holder: way.holder,
        said: way.said,
        count: way.count,
        rows: way
            .rows
            .into_iter()
            .map(|row| row.into_iter().map(|_| next()).collect())
            .collect(),
    });
    ways.collect()
}

/// Finds this many ways, at different joints, that remove all of the spare loads.
fn search(
    ways: &[Way<Residue>],
    (from, most): (usize, usize),
    span: &mut Span,
    (chosen, wanted): (&mut Vec<usize>, usize),
) -> bool {
    if span.rank() == wanted {
        return true;
    }
    if most == 0 {
        return false;
    }
    for (number, way) in ways.iter().enumerate().skip(from) {
        if chosen.iter().any(|other| ways[*other].holder == way.holder) {
            continue;
        }
        let Some(mut larger) = with(span, way) else {
            continue;
        };
        chosen.push(number);
        if search(ways, (number + 1, most - 1), &mut larger, (chosen, wanted)) {
            *span = larger;
            return true;
        }
        chosen.pop();
    }
    false
}

/// The span with the rows that a way releases; `None` if these are not all independent.
fn with(span: &Span, way: &Way<Residue>) -> Option<Span> {
    let mut larger = span.clone();
    let rows = way.rows.iter();
    let count = rows.filter(|row| larger.admit(0, row).is_none()).count();
    (count == way.count).then_some(larger)
}
