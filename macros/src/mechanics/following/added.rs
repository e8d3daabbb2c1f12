//! Inertia that loads add to a system: loads that resist the acceleration of their body, as those of
//! the water around it, and drives that resist the acceleration of their joint.
//!
//! ```text
//! W(a) = W(0) - C a,    C constant, C >= 0:    M q'' = f(q'')  ->  (M + sum of J^T C J) q'' = f(0)
//! ```
//!
//! So the matrix that is solved with is positive, like M by itself.

use crate::mechanics::tree::link::{Freedom, Tree};
use crate::mechanics::tree::{Built, LinkMotion, SpatialInertia, SpatialVector, motions, wrench};
use crate::model::{Felt, Labels, Load, Member, System, TreeJoint, Workspace};
use crate::symbolic::{Components, Graph, Id, Number};

/// The inertia that all loads together add.
#[derive(Default)]
pub struct Added {
    /// For each link on which such loads act.
    links: Vec<Option<AddedToLink>>,
    /// For each open freedom.
    armatures: Vec<Id>,
    /// The symbols of the accelerations of open freedoms, link by link.
    symbols: Vec<Vec<Id>>,
}

/// The inertia that the loads on a link add, in its axes.
struct AddedToLink {
    about_center: SpatialInertia,
    /// From the origin of the link to G.
    center: Components,
    /// The loads of a link that does not accelerate, about G.
    rest: SpatialVector,
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
        let masses: Vec<Id> = system.bodies.iter().map(|body| body.mass).collect();
        let mut links: Vec<Option<AddedToLink>> = Vec::new();
        links.resize_with(built.tree.links.len(), || None);
        for (number, (body, joint)) in system.bodies.iter().zip(&system.joints).enumerate() {
            if body.loads.iter().any(|load| load.follows(work)) {
                let felt = body.felt.as_ref()?;
                let added = AddedToLink::of(work, (body, felt), joint.pin, &masses)?;
                links[built.body(number)] = Some(added);
            }
        }
        let mut armatures = Vec::new();
        for (link, symbols) in built.tree.links.iter().zip(&symbols) {
            for (freedom, symbol) in link.open().zip(symbols) {
                let armature = armature(work, freedom, *symbol, &masses)?;
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
        })
    }

    /// Whether no load depends on an acceleration.
    pub fn is_nothing(&self) -> bool {
        self.links.is_empty()
    }

    /// The tree with loads written by this inertia, as functions of the symbols of the
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

impl AddedToLink {
    fn of(
        work: &mut Workspace,
        (body, felt): (&Member, &Felt),
        pin: Components,
        masses: &[Id],
    ) -> Option<Self> {
        let (follow, known): (Vec<&Load>, Vec<&Load>) =
            body.loads.iter().partition(|load| load.follows(work));
        let names = follow.iter().map(|load| &load.name);
        let all: Vec<&Load> = known.into_iter().chain(&felt.loads).collect();
        // no load was added later, or depends on the acceleration of anything else
        if !names.eq(felt.loads.iter().map(|load| &load.name))
            || all.iter().any(|load| load.follows(work))
        {
            return None;
        }
        let zeros = work.graph.zeros();
        let (force, moment) = wrench(work, body, all.iter().copied(), zeros);
        // a step of an acceleration has no slope
        let symbols = felt.acceleration.concat();
        if !work.graph.is_linear(&[force, moment].concat(), &symbols) {
            return None;
        }
        let columns = columns(work, (body, felt), &all, zeros);
        let is_constant = columns
            .iter()
            .flatten()
            .all(|one| work.graph.is_early(*one));
        let mut each = felt.loads.iter();
        let is_inertia = is_semidefinite(&mut work.graph, &columns, masses)
            || each.all(|load| resists(work, (body, felt), load, masses));
        if !is_constant || !is_inertia {
            return None;
        }
        let block = |row: usize, column: usize| {
            [0, 1, 2].map(|i| [0, 1, 2].map(|j| columns[3 * column + j][3 * row + i]))
        };
        let (graph, zero) = (&mut work.graph, zeros[0]);
        let still: Vec<(Id, Id)> = symbols.iter().map(|symbol| (*symbol, zero)).collect();
        Some(Self {
            about_center: SpatialInertia {
                angular: block(0, 0),
                mixed: block(0, 1),
                linear: block(1, 1),
            },
            center: graph.negate_vector(pin),
            rest: SpatialVector {
                angular: graph.replaced(moment, &still),
                linear: graph.replaced(force, &still),
            },
        })
    }

    /// The loads on the link about its origin, in this motion.
    fn load(&self, graph: &mut Graph, motion: &LinkMotion) -> SpatialVector {
        let acceleration = SpatialVector {
            linear: motion.at(graph, self.center),
            ..motion.acceleration
        };
        let taken = self.about_center.times(graph, &acceleration);
        let load = self.rest.minus(graph, taken);
        let lever = graph.cross(self.center, load.linear);
        SpatialVector {
            angular: graph.add_vectors(load.angular, lever),
            ..load
        }
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

/// Whether a load by itself adds an inertia, about G or about the point where it acts.
fn resists(
    work: &mut Workspace,
    (body, felt): (&Member, &Felt),
    load: &Load,
    masses: &[Id],
) -> bool {
    let points = [Some(work.graph.zeros()), load.point.offset(body.state.body)];
    points.into_iter().flatten().any(|point| {
        let columns = columns(work, (body, felt), &[load], point);
        is_semidefinite(&mut work.graph, &columns, masses)
    })
}

/// The inertia that loads on a body add, about a point at this offset from G, column by column:
/// minus the moment and the force by each component of the angular and the linear acceleration.
fn columns(
    work: &mut Workspace,
    (body, felt): (&Member, &Felt),
    loads: &[&Load],
    point: Components,
) -> Vec<Vec<Id>> {
    let (force, moment) = wrench(work, body, loads.iter().copied(), point);
    let graph = &mut work.graph;
    let [angular, linear] = felt.acceleration;
    // the acceleration of G, from that of the point
    let swept = graph.cross(angular, point);
    let of_center = graph.subtract_vectors(linear, swept);
    let given: Vec<(Id, Id)> = linear.into_iter().zip(of_center).collect();
    let parts = [moment, force]
        .map(|part| graph.replaced(part, &given))
        .concat();
    let one = graph.one();
    // in the plane, some components are zero
    let columns = felt.acceleration.concat().into_iter().map(|symbol| {
        let is_there = !graph.is_zero(symbol);
        let slopes = graph.change(&parts, |id| (is_there && id == symbol).then_some(one));
        let slopes = slopes.into_iter();
        slopes.map(|slope| graph.negate(slope)).collect()
    });
    columns.collect()
}

/// The inertia along a coordinate that its drive adds.
fn armature(work: &mut Workspace, freedom: &Freedom, symbol: Id, masses: &[Id]) -> Option<Id> {
    let mut others = work.accelerations_in(&[freedom.drive]);
    others.retain(|other| *other != symbol);
    let graph = &mut work.graph;
    let [slope] = graph.derivative(&[freedom.drive], symbol)[..] else {
        return None;
    };
    let added = graph.negate(slope);
    (others.is_empty() && is_known_sign(graph, added, masses)).then_some(added)
}

/// Whether a constant matrix is proved to be symmetric and to have no negative eigenvalue. Entries on
/// the diagonal with nothing beside them must not be negative; the others must be numbers times a
/// factor that is not.
fn is_semidefinite(graph: &mut Graph, columns: &[Vec<Id>], masses: &[Id]) -> bool {
    let count = columns.len();
    let is_symmetric = (0..count).all(|i| (0..i).all(|j| columns[i][j] == columns[j][i]));
    let is_coupled = |own: usize| (0..count).any(|j| j != own && !graph.is_zero(columns[j][own]));
    let (coupled, apart): (Vec<usize>, Vec<usize>) = (0..count).partition(|own| is_coupled(*own));
    let mut diagonal = coupled.iter().map(|own| columns[*own][*own]);
    let factor = diagonal.find(|entry| !graph.is_zero(*entry));
    let mut signs = apart.iter().map(|own| columns[*own][*own]).chain(factor);
    if !is_symmetric || !signs.all(|entry| is_known_sign(graph, entry, masses)) {
        return false;
    }
    let Some(factor) = factor else {
        return coupled.is_empty();
    };
    let mut rows = Vec::new();
    for row in &coupled {
        let ratios = coupled.iter().map(|column| {
            let ratio = graph.divide(columns[*column][*row], factor);
            graph.as_number(ratio).cloned()
        });
        match ratios.collect::<Option<Vec<Number>>>() {
            Some(row) => rows.push(row),
            None => return false,
        }
    }
    is_semidefinite_in_numbers(rows)
}

fn is_known_sign(graph: &Graph, entry: Id, masses: &[Id]) -> bool {
    graph.is_early(entry) && graph.is_never_negative(entry, masses)
}

/// The same for a symmetric matrix of numbers, by elimination of its last row.
fn is_semidefinite_in_numbers(mut rows: Vec<Vec<Number>>) -> bool {
    while let Some(own) = rows.pop() {
        let Some((pivot, beside)) = own.split_last() else {
            return true;
        };
        let is_alone = beside.iter().all(Number::is_zero);
        if pivot.is_negative() || pivot.is_undecided() || pivot.is_zero() && !is_alone {
            return false;
        }
        for (row, factor) in rows.iter_mut().zip(beside) {
            row.pop();
            for (entry, other) in row.iter_mut().zip(beside) {
                if let Some(share) = (factor.clone() * other.clone()).checked_div(pivot) {
                    *entry = entry.clone() - share;
                }
            }
        }
    }
    true
}
