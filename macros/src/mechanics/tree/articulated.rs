//! The articulated-body inertia of a link: its inertia together with everything that it carries,
//! while the joints move freely.

use crate::model::Labels;
use crate::symbolic::{Components, Graph, Id};

use super::link::{Freedom, Link, Tree};
use super::properties::Properties;
use super::spatial::{Along, SpatialInertia, SpatialVector};

type Rows = [Components; 3];

/// What the elimination of a joint coordinate gives: `q'' = drive - share . a`, where a is the
/// acceleration of the link without this coordinate.
pub struct Eliminated {
    pub twist: SpatialVector,
    pub drive: Id,
    pub share: SpatialVector,
    /// The reciprocal of the inertia along the coordinate.
    inverse: Id,
    /// The drive, minus the load that is needed without the acceleration of the coordinate.
    driving: Id,
}

impl Eliminated {
    /// Names the results.
    pub fn name(&self, labels: &mut Labels, of: &str) {
        let meaning = "1 / J of each joint, J with all that it carries";
        labels.explain([self.inverse], meaning);
        labels.explain(
            [self.driving],
            "load along each joint, minus what its body needs along it",
        );
        labels.explain(
            [self.drive],
            "acceleration of each joint if its carrier does not accelerate",
        );
        let meaning = "q'' = own - share . a, a of the carrier";
        self.share.explain(labels, meaning);
        labels.name(self.inverse, format!("inverse_inertia_{of}"));
        labels.name(self.driving, format!("driving_{of}"));
        labels.name(self.drive, format!("own_{of}"));
        self.share
            .name(labels, ["angular_share", "linear_share"], of);
    }
}

impl SpatialInertia {
    /// The inertia of a link by itself, with what loads add to it.
    pub fn of(graph: &mut Graph, link: &Link) -> Self {
        let Properties { mass, first, .. } = link.properties;
        let mut linear = [graph.zeros(); 3];
        for (axis, row) in linear.iter_mut().enumerate() {
            row[axis] = mass;
        }
        let own = Self {
            angular: link.properties.inertia,
            mixed: skew(graph, first),
            linear,
        };
        own.plus(graph, &link.added)
    }

    /// Frees a coordinate of the link, and adapts the load that is lacking for its motion.
    pub fn eliminate(
        &mut self,
        graph: &mut Graph,
        freedom: &Freedom,
        lacking: &mut SpatialVector,
    ) -> Eliminated {
        let (twist, drive) = (freedom.twist, freedom.drive);
        // with an armature, a part of the inertia along the coordinate remains
        let axis = twist.axis(graph);
        let axis = axis.filter(|_| graph.is_zero(freedom.armature));
        let of_rate = self.times(graph, &twist).quantities(graph);
        let inertia = twist.dot(graph, of_rate);
        let inertia = graph.add(inertia, freedom.armature);
        let one = graph.one();
        let inverse = graph.divide(one, inertia);
        let inverse = graph.quantity(inverse);
        let mut share = of_rate.scaled(graph, inverse).quantities(graph);
        match axis {
            Some(Along::Angular(axis)) => share.angular[axis] = twist.angular[axis],
            Some(Along::Linear(axis)) => share.linear[axis] = twist.linear[axis],
            None => {}
        }
        let needed = twist.dot(graph, *lacking);
        let driving = graph.subtract(drive, needed);
        let driving = graph.quantity(driving);
        let outer = |graph: &mut Graph, rows: &Rows, a: Components, b: Components| {
            let mut less = *rows;
            for (i, row) in less.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    let product = graph.multiply(a[i], b[j]);
                    *entry = graph.subtract(*entry, product);
                }
            }
            less
        };
        self.angular = outer(graph, &self.angular, of_rate.angular, share.angular);
        self.mixed = outer(graph, &self.mixed, of_rate.angular, share.linear);
        self.linear = outer(graph, &self.linear, of_rate.linear, share.linear);
        self.mirror();
        let made = share.scaled(graph, driving);
        *lacking = lacking.plus(graph, made);
        if let Some(axis) = axis {
            let drive = twist.scaled(graph, drive);
            self.give_way(graph, axis, drive, lacking);
        }
        let drive = graph.multiply(driving, inverse);
        Eliminated {
            twist,
            drive: graph.quantity(drive),
            share,
            inverse,
            driving,
        }
    }

    /// Along a freed coordinate, no inertia is left, and the load is the drive.
    fn give_way(
        &mut self,
        graph: &Graph,
        along: Along,
        drive: SpatialVector,
        lacking: &mut SpatialVector,
    ) {
        let zero = graph.zero();
        match along {
            Along::Angular(axis) => {
                self.angular[axis] = graph.zeros();
                self.mixed[axis] = graph.zeros();
                for row in &mut self.angular {
                    row[axis] = zero;
                }
                lacking.angular[axis] = drive.angular[axis];
            }
            Along::Linear(axis) => {
                self.linear[axis] = graph.zeros();
                for row in self.linear.iter_mut().chain(&mut self.mixed) {
                    row[axis] = zero;
                }
                lacking.linear[axis] = drive.linear[axis];
            }
        }
    }

    /// The same inertia about the origin of the carrier, in the axes of the carrier.
    pub fn seen_by_carrier(&self, graph: &mut Graph, link: &Link) -> Self {
        let turned = self.turned(graph, link.turning).quantities(graph);
        turned.seen_from(graph, link.place)
    }
}

/// `[v]x`
fn skew(graph: &mut Graph, [x, y, z]: Components) -> Rows {
    let zero = graph.zero();
    let [less_x, less_y, less_z] = graph.negate_vector([x, y, z]);
    [[zero, less_z, y], [z, zero, less_x], [less_y, x, zero]]
}

/// A moment and a force about the origin of the link, moved to the origin of the carrier, in the
/// axes of the carrier.
pub fn wrench_on_carrier(graph: &mut Graph, link: &Link, wrench: SpatialVector) -> SpatialVector {
    let moment = link.turning.to_carrier(graph, wrench.angular);
    let force = link.turning.to_carrier(graph, wrench.linear);
    let force = graph.quantities(force);
    let lever = graph.cross(link.place, force);
    SpatialVector {
        angular: graph.add_vectors(moment, lever),
        linear: force,
    }
}

/// What a link passes to its carrier: its inertia, and the load that it lacks.
pub struct Passed<'a>(pub &'a Link, pub SpatialInertia, pub SpatialVector);

/// Names what links pass to their carriers, unless it is all that these have.
pub fn name_passed(labels: &mut Labels, tree: &Tree, passed: &[Passed<'_>]) {
    for Passed(link, inertia, load) in passed {
        let Some(carrier) = link.carrier else {
            continue;
        };
        let of = format!("{}_on_{}", link.name, tree.links[carrier].name);
        inertia.name(labels, &of, "the same inertia on the carrier, in its axes");
        load.name_lacking(labels, &of);
    }
}
