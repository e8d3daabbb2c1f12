//! The bias: the motion of the links with zero joint accelerations, and the loads that it needs.

use crate::model::Labels;
use crate::symbolic::{Components, Graph, Id};

use super::link::{Link, Tree};
use super::properties::Properties;
use super::spatial::SpatialVector;

/// The motion of a link, in its axes.
#[derive(Clone, Copy)]
pub struct LinkMotion {
    /// The angular velocity.
    pub w: Components,
    /// The angular acceleration, and the acceleration of the origin minus that of free fall.
    pub acceleration: SpatialVector,
    /// `[w']x + w w - w^2 1`: times an offset, it is what the offset adds to the acceleration.
    pub sweep: [Components; 3],
}

impl LinkMotion {
    pub fn new(graph: &mut Graph, w: Components, acceleration: SpatialVector) -> Self {
        Self {
            w,
            acceleration,
            sweep: sweep(graph, w, acceleration.angular),
        }
    }

    pub fn ground(graph: &mut Graph, gravity: Components) -> Self {
        Self {
            w: graph.zeros(),
            acceleration: SpatialVector {
                angular: graph.zeros(),
                linear: graph.negate_vector(gravity),
            },
            sweep: [graph.zeros(); 3],
        }
    }

    /// The motion of a link on a carrier with this motion.
    pub fn carried(&self, graph: &mut Graph, link: &Link) -> Self {
        let zeros = graph.zeros();
        let sum = |graph: &mut Graph, part: fn(&SpatialVector) -> Components| {
            link.freedoms.iter().fold(zeros, |sum, freedom| {
                let scaled = graph.scale_vector(freedom.rate, part(&freedom.twist));
                graph.add_vectors(sum, scaled)
            })
        };
        let mut given = SpatialVector::zero(graph);
        for freedom in &link.freedoms {
            if let Some(rate) = freedom.given {
                let made = freedom.twist.scaled(graph, rate);
                given = given.plus(graph, made);
            }
        }
        let turning = sum(graph, |twist| twist.angular);
        let carried = link.turning.to_link(graph, self.w);
        let carried = graph.quantities(carried);
        let w = graph.add_vectors(carried, turning);
        let w = graph.quantities(w);
        let swung = graph.cross(carried, turning);
        let angular = link.turning.to_link(graph, self.acceleration.angular);
        let angular = graph.add_vectors(angular, swung);
        let angular = graph.add_vectors(angular, given.angular);
        let angular = graph.quantities(angular);
        let linear = if link.falls {
            zeros
        } else {
            let origin = if link.is_free {
                self.acceleration.linear
            } else {
                self.at(graph, link.place)
            };
            let origin = link.turning.to_link(graph, origin);
            let sliding = sum(graph, |twist| twist.linear);
            let sliding = graph.add_vectors(sliding, sliding);
            let coriolis = graph.cross(carried, sliding);
            let origin = graph.add_vectors(origin, coriolis);
            graph.add_vectors(origin, given.linear)
        };
        let linear = graph.quantities(linear);
        Self::new(graph, w, SpatialVector { angular, linear })
    }

    /// The acceleration of a point at this offset from the origin.
    pub fn at(&self, graph: &mut Graph, offset: Components) -> Components {
        let swept = graph.transform(&self.sweep, offset);
        let linear = graph.add_vectors(self.acceleration.linear, swept);
        graph.quantities(linear)
    }

    /// The same motion if the coordinates of the link accelerate. Those of a free link are given
    /// along world axes first.
    pub fn accelerated(&self, graph: &mut Graph, tree: &Tree, link: &Link, rates: &[Id]) -> Self {
        let mut acceleration = self.acceleration;
        for (freedom, rate) in link.open().zip(rates) {
            let made = freedom.twist.scaled(graph, *rate);
            acceleration = acceleration.plus(graph, made);
        }
        if link.is_free {
            // the linear part of the twists is along world axes
            let fall = graph.subtract_vectors(acceleration.linear, tree.gravity);
            acceleration.linear = link.turning.to_link(graph, fall);
        }
        let acceleration = acceleration.quantities(graph);
        Self::new(graph, self.w, acceleration)
    }

    /// The same acceleration without velocity. Along a twist from the ground, a velocity `v` needs no
    /// load along it: `v . (v x* I v) = 0`.
    fn at_rest(&self, graph: &Graph) -> Self {
        Self {
            w: graph.zeros(),
            sweep: [graph.zeros(); 3],
            ..*self
        }
    }

    /// The moment about the origin and the force that this motion needs, which are linear in mass,
    /// first moment and inertia.
    pub fn taken_by(&self, graph: &mut Graph, properties: &Properties) -> SpatialVector {
        let (h, rows, a) = (
            properties.first,
            &properties.inertia,
            self.acceleration.linear,
        );
        let pushed = graph.scale_vector(properties.mass, a);
        let swept = graph.transform(&self.sweep, h);
        let force = graph.add_vectors(pushed, swept);
        let turned = self.moment(graph, rows);
        let lever = graph.cross(h, a);
        let moment = graph.add_vectors(turned, lever);
        SpatialVector {
            angular: moment,
            linear: force,
        }
    }

    /// `J w' + w x J w`, from the products of w that the sweep contains.
    fn moment(&self, graph: &mut Graph, rows: &[Components; 3]) -> Components {
        let (s, w) = (&self.sweep, self.w);
        [0, 1, 2].map(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let mut terms = Vec::new();
            terms.push(graph.multiply(rows[i][i], self.acceleration.angular[i]));
            let products = graph.multiply(w[j], w[k]);
            let products = graph.quantity(products);
            let difference = graph.subtract(rows[k][k], rows[j][j]);
            terms.push(graph.multiply(difference, products));
            let less = graph.multiply(rows[i][j], s[k][i]);
            terms.push(graph.negate(less));
            terms.push(graph.multiply(rows[i][k], s[j][i]));
            let squares = graph.subtract(s[j][j], s[k][k]);
            terms.push(graph.multiply(rows[j][k], squares));
            graph.sum(&terms)
        })
    }
}

/// `[alpha]x + w w - w^2 1`
fn sweep(graph: &mut Graph, w: Components, alpha: Components) -> [Components; 3] {
    let squares = w.map(|part| {
        let square = graph.square(part);
        graph.quantity(square)
    });
    let mut rows = [graph.zeros(); 3];
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let across = graph.add(squares[j], squares[k]);
        let entry = graph.negate(across);
        rows[i][i] = graph.quantity(entry);
        let product = graph.multiply(w[i], w[j]);
        let product = graph.quantity(product);
        let (less, more) = (
            graph.subtract(product, alpha[k]),
            graph.add(product, alpha[k]),
        );
        (rows[i][j], rows[j][i]) = (graph.quantity(less), graph.quantity(more));
    }
    rows
}

/// The motion of all links without accelerations of joints, and the moment and force that each
/// lacks, about its origin.
pub fn derive_bias(
    graph: &mut Graph,
    labels: &mut Labels,
    tree: &Tree,
) -> Vec<(LinkMotion, SpatialVector)> {
    let ground = LinkMotion::ground(graph, tree.gravity);
    let mut all: Vec<(LinkMotion, SpatialVector)> = Vec::new();
    for link in &tree.links {
        let carrier = link.carrier.map_or(ground, |carrier| all[carrier].0);
        let moving = carrier.carried(graph, link);
        labels.explain(
            moving.w,
            "w of each body, in its axes: of its carrier, and of its joint",
        );
        labels.vector_or_one("w", &link.name, moving.w);
        let meaning = "w' and a of each body while no joint accelerates, relative to free fall";
        moving.acceleration.explain(labels, meaning);
        moving.acceleration.name(labels, ["alpha", "a"], &link.name);
        if let Some(number) = link.carrier.filter(|_| !link.is_free) {
            let of = format!("a_{}_at_{}", tree.links[number].name, link.name);
            labels.vector(&of, carrier.at(graph, link.place));
        }
        let meaning = "S r = w' x r + w x (w x r): what an arm r adds to a";
        labels.explain(moving.sweep.concat(), meaning);
        labels.matrix(&format!("sweep_{}", link.name), &moving.sweep);
        let taken = if link.moves_along_one_twist() {
            moving.at_rest(graph).taken_by(graph, &link.properties)
        } else {
            moving.taken_by(graph, &link.properties)
        };
        let lacking = taken.minus(graph, link.load());
        all.push((moving, lacking));
    }
    all
}
