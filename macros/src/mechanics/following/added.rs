//! Inertia that loads add to a system: loads that resist the acceleration of their body, as those of
//! the water around it, and drives that resist the acceleration of their joint.
//!
//! ```text
//! W(a) = W(0) - C a,    C constant, C >= 0:    M q'' = f(q'')  ->  (M + sum of J^T C J) q'' = f(0)
//! ```
//!
//! So the matrix that is solved with is positive, like M by itself. If the sign of C is that of
//! parameters, `new` checks that each body has a positive inertia together with what its loads add.

use proc_macro2::{Ident, Span};

use crate::mechanics::tree::link::{Freedom, Tree};
use crate::mechanics::tree::{Built, motions};
use crate::model::{Labels, Property, System, TreeJoint, Workspace};
use crate::symbolic::Id;

use super::added_to_link::AddedToLink;
use super::definite::{is_by_default, is_known_sign, is_not_negative};

/// The inertia that all loads together add.
#[derive(Default)]
pub struct Added {
    /// For each link on which such loads act.
    links: Vec<Option<AddedToLink>>,
    /// For each open freedom.
    armatures: Vec<Id>,
    /// The symbols of the accelerations of open freedoms, link by link.
    symbols: Vec<Vec<Id>>,
    /// What `new` checks for the parameters.
    pub conditions: Vec<Property>,
}

impl Added {
    /// `None` if loads depend on accelerations in any other way.
    pub fn of(system: &System, work: &mut Workspace, built: &Built) -> Option<Self> {
        if !follows(system, work) {
            return Some(Self::default());
        }
        let open = system.joints.iter().filter(|joint| !joint.is_driven());
        let symbols = open.flat_map(TreeJoint::accelerations);
        let symbols: Vec<Vec<Id>> = built.tree.by_link(symbols);
        // a frame has none
        let masses = system.bodies.iter().map(|body| body.mass);
        let masses: Vec<Id> = masses.filter(|mass| !work.graph.is_zero(*mass)).collect();
        let known = (&masses[..], &system.defaults);
        let mut properties = Vec::new();
        let mut links: Vec<Option<AddedToLink>> = Vec::new();
        links.resize_with(built.tree.links.len(), || None);
        for (number, (body, joint)) in system.bodies.iter().zip(&system.joints).enumerate() {
            if body.loads.iter().any(|load| load.follows(work)) {
                let felt = body.felt.as_ref()?;
                let added = AddedToLink::of(work, (body, felt), joint.pin, known)?;
                properties.extend(added.conditions.clone());
                links[built.body(number)] = Some(added);
            }
        }
        let mut armatures = Vec::new();
        for (link, symbols) in built.tree.links.iter().zip(&symbols) {
            for (freedom, symbol) in link.open().zip(symbols) {
                let armature = armature(work, freedom, *symbol)?;
                if !is_known_sign(&work.graph, armature, &masses) {
                    let value = work.graph.add(freedom.armature, armature);
                    let (graph, defaults) = (&mut work.graph, &system.defaults);
                    if !is_by_default(graph, &[value], defaults, is_not_negative) {
                        return None;
                    }
                    properties.push(Property {
                        of: Ident::new(&freedom.joint, Span::call_site()),
                        word: "armature with its drive",
                        value,
                        may_vanish: true,
                    });
                }
                // the coordinates of a free link are along world axes
                if link.is_free && !work.graph.is_zero(armature) {
                    return None;
                }
                armatures.push(armature);
            }
        }
        Some(Self {
            links,
            armatures,
            symbols,
            conditions: properties,
        })
    }

    /// Whether no load depends on an acceleration.
    pub fn is_nothing(&self) -> bool {
        self.links.is_empty()
    }

    /// The tree with its loads written as `W(0) - C a`, as functions of the symbols of the
    /// accelerations.
    pub fn by_symbols(&self, work: &mut Workspace, tree: &Tree) -> Tree {
        if self.is_nothing() {
            return tree.clone();
        }
        let mut given = self.resist(work, tree, &self.symbols);
        let graph = &mut work.graph;
        let symbols = self.symbols.iter().flatten();
        for ((freedom, symbol), armature) in open(&mut given).zip(symbols).zip(&self.armatures) {
            let taken = graph.multiply(*armature, *symbol);
            freedom.drive = graph.subtract(freedom.drive, taken);
        }
        given
    }

    /// The tree with this inertia, and with the loads of its motion without accelerations of its
    /// joints.
    pub fn put_into(&self, work: &mut Workspace, tree: &Tree) -> Tree {
        if self.is_nothing() {
            return tree.clone();
        }
        let zero = work.graph.zero();
        let still: Vec<Vec<Id>> = self
            .symbols
            .iter()
            .map(|own| vec![zero; own.len()])
            .collect();
        let mut resisting = self.resist(work, tree, &still);
        let graph = &mut work.graph;
        for (link, added) in resisting.links.iter_mut().zip(&self.links) {
            if let Some(added) = added {
                let own = added.about_center.seen_from(graph, added.center);
                link.added = link.added.plus(graph, &own);
            }
        }
        for (freedom, armature) in open(&mut resisting).zip(&self.armatures) {
            freedom.armature = graph.add(freedom.armature, *armature);
        }
        for index in 0..tree.links.len() {
            // gravity does not act on added inertia
            let mut carried = self.links.iter().enumerate();
            let bears =
                carried.any(|(above, added)| added.is_some() && tree.is_above(above, index));
            resisting.links[index].falls &= !bears;
        }
        resisting
    }

    /// The tree with the loads on its links at these accelerations of the coordinates, and with the
    /// drives at zero accelerations.
    fn resist(&self, work: &mut Workspace, tree: &Tree, accelerations: &[Vec<Id>]) -> Tree {
        let (graph, labels) = (&mut work.graph, &mut work.labels);
        let zero = graph.zero();
        let symbols = self.symbols.concat().into_iter();
        let still: Vec<(Id, Id)> = symbols.map(|symbol| (symbol, zero)).collect();
        let mut resisting = tree.clone();
        resisting.replace(graph, &still);
        // absolute accelerations, not those relative to free fall
        let weightless = Tree {
            gravity: graph.zeros(),
            ..tree.clone()
        };
        let motions = motions((graph, &mut Labels::silent()), &weightless, accelerations);
        for ((link, motion), added) in resisting.links.iter_mut().zip(&motions).zip(&self.links) {
            let linear = motion.acceleration.linear;
            labels.explain(linear, "a of each body relative to the ground");
            labels.vector(&format!("a_{}_absolute", link.name), linear);
            if let Some(added) = added {
                let center = motion.at(graph, added.center);
                labels.explain(center, "a of each G relative to the ground");
                labels.vector(&format!("a_{}_G", link.name), center);
                let load = added.load(graph, motion).quantities(graph);
                load.explain(labels, "given loads on a body");
                load.name(labels, ["load_moment", "load_force"], &link.name);
                (link.moment, link.force) = (load.angular, load.linear);
            }
        }
        resisting
    }
}

/// The open freedoms of a tree, link by link.
fn open(tree: &mut Tree) -> impl Iterator<Item = &mut Freedom> {
    let freedoms = tree.links.iter_mut().flat_map(|link| &mut link.freedoms);
    freedoms.filter(|freedom| freedom.given.is_none())
}

/// Whether any load or drive depends on an acceleration.
fn follows(system: &System, work: &Workspace) -> bool {
    let mut loads = system.bodies.iter().flat_map(|body| &body.loads);
    let drives = system.joints.iter().flat_map(|joint| &joint.drives);
    let drives: Vec<Id> = drives.copied().collect();
    loads.any(|load| load.follows(work)) || !work.accelerations_in(&drives).is_empty()
}

/// The inertia along a coordinate that its drive adds. `None` if it is not constant, or not all that
/// the drive does with accelerations.
fn armature(work: &mut Workspace, freedom: &Freedom, symbol: Id) -> Option<Id> {
    let mut others = work.accelerations_in(&[freedom.drive]);
    others.retain(|other| *other != symbol);
    let graph = &mut work.graph;
    let [slope] = graph.derivative(&[freedom.drive], symbol)[..] else {
        return None;
    };
    let added = graph.negate(slope);
    let is_all = others.is_empty() && graph.is_linear(&[freedom.drive], &[symbol]);
    (is_all && graph.is_early(added)).then_some(added)
}
