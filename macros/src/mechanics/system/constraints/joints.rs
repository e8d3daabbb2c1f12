//! The rows of a joint that closes a loop: constraints between two links. Each has its value, its
//! rate, its bias (the derivative of the rate without joint accelerations), and its slopes along
//! the rates of the joints.

use crate::mechanics::tree::link::Tree;
use crate::mechanics::unknowns::Activity;
use crate::model::Connection;
use crate::symbolic::{Comparison, Components, Function, Graph, Id};

use super::held::{Held, Thread, at_zero, held};
use super::loops::{Ends, Loop};
use super::placed::{Placed, Spot};
use super::row::ConstraintRow;

/// One constraint of a joint.
pub struct JointRow {
    pub row: ConstraintRow,
    /// A unit of its load: the force and moment on the carried body, at its point of the joint, in
    /// the axes of the loop. On the carrier, the opposite acts at the same place.
    pub force: Components,
    pub moment: Components,
}

/// The constraints of a joint that closes a loop.
pub fn rows(graph: &mut Graph, tree: &Tree, own: &Loop, ends: &Ends<'_>) -> Vec<JointRow> {
    let sides = ends.links.map(|link| own.placed(link));
    let spots = [0, 1].map(|end| sides[end].spot(graph, ends.offsets[end]));
    let joined = Joined { sides, spots };
    let held = held(graph, ends.closing, ends.is_planar);
    let count = held.len();
    let rows = held.into_iter().enumerate().map(|(number, held)| {
        let name = if count == 1 {
            ends.closing.name.to_string()
        } else {
            format!("{}_{}", ends.closing.name, number + 1)
        };
        row(graph, tree, own, (ends, &joined), held, name)
    });
    rows.collect()
}

fn row(
    graph: &mut Graph,
    tree: &Tree,
    own: &Loop,
    (ends, joined): (&Ends<'_>, &Joined<'_>),
    held: Held,
    name: String,
) -> JointRow {
    let measured = joined.measured(graph, held, ends.closing);
    let load = [measured.force, measured.moment];
    let [force, moment] = load.map(|vector| graph.quantities(vector));
    let places = match held {
        Held::Place(_) => joined.spots.map(|spot| spot.place),
        _ => [joined.spots[1].place; 2],
    };
    let slopes = slopes(graph, tree, own, (ends, places), [force, moment]);
    let [value, rate, bias] = measured.change.map(|id| graph.quantity(id));
    let facing = joined.facing(graph, held);
    JointRow {
        row: ConstraintRow {
            name,
            value: Some(value),
            facing,
            rate,
            bias,
            slopes,
            activity: Activity::default(),
        },
        force,
        moment,
    }
}

/// Both sides of a joint, carrier first, and its points on them.
struct Joined<'a> {
    sides: [&'a Placed; 2],
    spots: [Spot; 2],
}

/// A constraint with its first and second derivatives, and a unit of its load.
struct Measured {
    change: [Id; 3],
    force: Components,
    moment: Components,
}

impl Joined<'_> {
    fn measured(&self, graph: &mut Graph, held: Held, closing: &Connection) -> Measured {
        let [carrier, _] = self.sides;
        let zeros = graph.zeros();
        match held {
            Held::Place(e) => Measured {
                change: self.apart(graph).map(|vector| graph.dot(e, vector)),
                force: e,
                moment: zeros,
            },
            Held::Across(own) => {
                let e = carrier.to_frame(graph, own);
                Measured {
                    change: self.along(graph, e),
                    force: e,
                    moment: zeros,
                }
            }
            Held::Thread(thread) => {
                let e = carrier.to_frame(graph, thread.axis);
                let change = self.along_thread(graph, &thread, e);
                let moment = graph.scale_vector(thread.pitch, e);
                Measured {
                    change,
                    force: e,
                    moment: graph.negate_vector(moment),
                }
            }
            Held::Between(directions, _) => self.between(graph, directions, closing),
        }
    }

    /// The cosine of the angle between two directions that should agree.
    fn facing(&self, graph: &mut Graph, held: Held) -> Option<Id> {
        let Held::Between(_, Some([own, other])) = held else {
            return None;
        };
        let [carrier, carried] = self.sides;
        let own = carrier.to_frame(graph, own);
        let other = carried.to_frame(graph, other);
        let cosine = graph.dot(own, other);
        Some(graph.quantity(cosine))
    }

    /// The vector between the two points, with its first and second derivatives.
    fn apart(&self, graph: &mut Graph) -> [Components; 3] {
        let parts: [fn(&Spot) -> Components; 3] = [
            |spot| spot.place,
            |spot| spot.velocity,
            |spot| spot.acceleration,
        ];
        parts.map(|part| {
            let both = graph.subtract_vectors(part(&self.spots[1]), part(&self.spots[0]));
            graph.quantities(both)
        })
    }

    /// The rate at which one side rotates relative to the other, and its derivative.
    fn turning(&self, graph: &mut Graph) -> [Components; 2] {
        let [carrier, carried] = self.sides;
        let pairs = [(carried.w, carrier.w), (carried.alpha, carrier.alpha)];
        pairs.map(|(own, of_carrier)| graph.subtract_vectors(own, of_carrier))
    }

    /// The distance of the points along a direction of the carrier.
    fn along(&self, graph: &mut Graph, e: Components) -> [Id; 3] {
        let [r, v, a] = self.apart(graph);
        let [carrier, _] = self.sides;
        let swept = graph.cross(carrier.w, e);
        let swept = graph.quantities(swept);
        let inwards = graph.cross(carrier.w, swept);
        let turned = graph.cross(carrier.alpha, e);
        let bent = graph.add_vectors(inwards, turned);
        let along = graph.dot(e, v);
        let across = graph.dot(swept, r);
        let rate = graph.add(along, across);
        let (first, second, third) = (graph.dot(e, a), graph.dot(swept, v), graph.dot(bent, r));
        let bias = graph.sum(&[first, second, second, third]);
        [graph.dot(e, r), rate, bias]
    }

    /// The same along the axis of a thread, minus the advance of the thread as it rotates. Whole
    /// turns do not count:
    ///
    /// ```text
    /// p sin h                     h = x / p - angle,  p: pitch, x: the place along the axis
    /// p (± 2 - sin h)             beyond a quarter turn: zero nowhere, not even at half a turn
    /// ```
    ///
    /// The rate is that of `p h`, which is equal where the constraint holds. From anywhere, steps
    /// along it lead to the nearest turn.
    fn along_thread(&self, graph: &mut Graph, thread: &Thread, e: Components) -> [Id; 3] {
        let [carrier, carried] = self.sides;
        let [place, rate, bias] = self.along(graph, e);
        let [w, alpha] = self.turning(graph);
        let swept = graph.cross(carrier.w, e);
        let (turned, moved) = (graph.dot(e, alpha), graph.dot(swept, w));
        let turning = [graph.dot(e, w), graph.add(turned, moved)];
        let [rate, bias] = [(rate, turning[0]), (bias, turning[1])].map(|(whole, turning)| {
            let part = graph.multiply(thread.pitch, turning);
            graph.subtract(whole, part)
        });
        let own = carrier.to_frame(graph, thread.across[0]);
        let other = carried.to_frame(graph, thread.across[1]);
        let normal = graph.cross(own, other);
        let (cosine, sine) = (graph.dot(own, other), graph.dot(e, normal));
        let angle = graph.divide(place, thread.pitch);
        let [sine_of_place, cosine_of_place] =
            [Function::Sin, Function::Cos].map(|function| graph.apply(function, &[angle]));
        let [first, second, third, fourth] = [
            (sine_of_place, cosine),
            (cosine_of_place, sine),
            (cosine_of_place, cosine),
            (sine_of_place, sine),
        ]
        .map(|(a, b)| graph.multiply(a, b));
        let sine = graph.subtract(first, second);
        let cosine = graph.add(third, fourth);
        let [zero, two] = [0, 2].map(|number| graph.integer(number));
        let behind = graph.compare(Comparison::Less, sine, zero);
        let beyond = graph.compare(Comparison::Less, cosine, zero);
        let minus_two = graph.negate(two);
        let end = graph.select(behind, minus_two, two);
        let rest = graph.subtract(end, sine);
        let value = graph.select(beyond, rest, sine);
        [graph.multiply(thread.pitch, value), rate, bias]
    }

    /// The angle between a direction of the carrier and one of the carried body, minus its value at
    /// zero coordinates. A moment along the normal of both keeps it.
    fn between(
        &self,
        graph: &mut Graph,
        [own, other]: [Components; 2],
        closing: &Connection,
    ) -> Measured {
        let [carrier, carried] = self.sides;
        let e = carrier.to_frame(graph, own);
        let d = carried.to_frame(graph, other);
        let n = graph.cross(d, e);
        let n = graph.quantities(n);
        let [w, alpha] = self.turning(graph);
        let rate = graph.dot(w, n);
        let d_rate = graph.cross(carried.w, d);
        let e_rate = graph.cross(carrier.w, e);
        let first = graph.cross(d_rate, e);
        let second = graph.cross(d, e_rate);
        let n_rate = graph.add_vectors(first, second);
        let (turned, moved) = (graph.dot(alpha, n), graph.dot(w, n_rate));
        let bias = graph.add(turned, moved);
        // at zero coordinates, the angle is that between the directions as written
        let other = at_zero(graph, closing, other);
        let start = graph.dot(own, other);
        let now = graph.dot(e, d);
        Measured {
            change: [graph.subtract(now, start), rate, bias],
            force: graph.zeros(),
            moment: n,
        }
    }
}

/// The power of a force and a moment per rate of each open freedom. They act on the carried body,
/// and their opposites on the carrier, each force at its place.
fn slopes(
    graph: &mut Graph,
    tree: &Tree,
    own: &Loop,
    (ends, places): (&Ends<'_>, [Components; 2]),
    [force, moment]: [Components; 2],
) -> Vec<Id> {
    let path = |end: usize| {
        let mut path = Vec::new();
        let mut at = ends.links[end];
        while let Some(link) = at {
            path.push(link);
            at = tree.links[link].carrier;
        }
        path
    };
    let [carrier, carried] = [path(0), path(1)];
    let mut all = Vec::new();
    for (index, link) in tree.links.iter().enumerate() {
        let (on, off) = (carried.contains(&index), carrier.contains(&index));
        for freedom in link.open() {
            // a freedom that carries both sides moves them alike
            if on == off {
                all.push(graph.zero());
                continue;
            }
            let placed = own.placed(Some(index));
            let about = placed.to_frame(graph, freedom.twist.angular);
            let along = if link.is_free {
                freedom.twist.linear
            } else {
                placed.to_frame(graph, freedom.twist.linear)
            };
            let arm = graph.subtract_vectors(places[usize::from(on)], placed.origin);
            let arm = graph.quantities(arm);
            let lever = graph.cross(arm, force);
            let whole = graph.add_vectors(lever, moment);
            let (turning, sliding) = (graph.dot(about, whole), graph.dot(along, force));
            let power = graph.add(turning, sliding);
            let power = if on { power } else { graph.negate(power) };
            all.push(graph.quantity(power));
        }
    }
    all
}
