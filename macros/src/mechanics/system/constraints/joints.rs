//! The rows of a joint that closes a loop: constraints between two links, each with its value, its
//! rate, its missing acceleration, and its slopes by the rates of the joints.

use crate::mechanics::tree::link::Tree;
use crate::mechanics::tree::turning::Turning;
use crate::model::{Closing, Part};
use crate::symbolic::{Components, Function, Graph, Id};

use super::row::Row;
use super::world::{Placed, Spot};

/// One constraint of a joint.
pub struct JointRow {
    pub row: Row,
    /// A unit of its load: force and moment on the carried body, at its point of the joint, world
    /// axes; on the carrier the opposite, at the same place.
    pub force: Components,
    pub moment: Components,
}

/// The kind of a constraint.
#[derive(Clone, Copy)]
enum Held {
    /// The point of the carried body, along a direction of the world.
    Place(Components),
    /// The same along a direction that is fixed in the carrier.
    Across(Components),
    /// The angle between a direction of the carrier and one of the carried body.
    Between(Components, Components),
    /// The place along a direction that is fixed in the carrier, by the angle about it.
    Thread(Thread),
}

/// Of a screw.
#[derive(Clone, Copy)]
struct Thread {
    axis: Components,
    /// A direction perpendicular to the axis: fixed in the carrier, and fixed in the carried body.
    /// Both agree at zero.
    across: [Components; 2],
    /// Metres per radian.
    pitch: Id,
}

/// Both sides of a joint that closes a loop.
pub struct Ends<'a> {
    pub closing: &'a Closing,
    /// The links, none for the ground; offsets of the joint from their origins.
    pub links: [Option<usize>; 2],
    pub offsets: [Components; 2],
    pub is_planar: bool,
}

/// The constraints of a joint that closes a loop.
pub fn rows(graph: &mut Graph, tree: &Tree, placed: &[Placed], ends: &Ends<'_>) -> Vec<JointRow> {
    let ground = Placed::ground(graph);
    let sides = ends
        .links
        .map(|link| link.map_or(&ground, |link| &placed[link]));
    let spots = [0, 1].map(|end| sides[end].spot(graph, ends.offsets[end]));
    let held = held(graph, ends);
    let count = held.len();
    let rows = held.into_iter().enumerate().map(|(number, held)| {
        let name = if count == 1 {
            ends.closing.name.to_string()
        } else {
            format!("{}_{}", ends.closing.name, number + 1)
        };
        row(graph, tree, placed, (ends, sides, spots), held, name)
    });
    rows.collect()
}

/// The constraints of a joint, one per held direction.
fn held(graph: &mut Graph, ends: &Ends<'_>) -> Vec<Held> {
    let closing = ends.closing;
    let units = graph.unit_vectors();
    let turned = |graph: &mut Graph, vector: Components| at_zero(graph, closing, vector);
    let axes = if ends.is_planar { 2 } else { 3 };
    let places = || units[..axes].iter().map(|unit| Held::Place(*unit));
    // all directions of both bodies keep their angles to each other
    let still = |graph: &mut Graph| -> Vec<Held> {
        if ends.is_planar {
            return vec![Held::Between(turned(graph, units[0]), units[1])];
        }
        let pairs = [(0, 1), (1, 2), (2, 0)];
        pairs
            .into_iter()
            .map(|(i, j)| Held::Between(turned(graph, units[i]), units[j]))
            .collect()
    };
    let mut all = Vec::new();
    match (closing.kind.parts, closing.directions.as_slice()) {
        // hinges in the plane, and ball joints
        ([Part::Turn(_)], _) if ends.is_planar => all.extend(places()),
        ([Part::Ball], _) => all.extend(places()),
        ([Part::Turn(_)], [axis, across @ ..]) => {
            all.extend(places());
            for across in across {
                all.push(Held::Between(turned(graph, *across), *axis));
            }
        }
        ([Part::Slide(_), Part::Turn(_)], [along, normal]) if ends.is_planar => {
            let across = graph.cross(*normal, *along);
            all.push(Held::Across(turned(graph, across)));
        }
        ([Part::Slide(_), Part::Turn(_)], [axis, across @ ..]) => {
            for across in across {
                let across = turned(graph, *across);
                all.extend([Held::Across(across), Held::Between(across, *axis)]);
            }
        }
        ([Part::Screw], [axis, across @ ..]) => {
            for across in across {
                let across = turned(graph, *across);
                all.extend([Held::Across(across), Held::Between(across, *axis)]);
            }
            let first = across.iter().zip(closing.pitch).next();
            all.extend(first.map(|(across, pitch)| {
                let (axis, own) = (turned(graph, *axis), turned(graph, *across));
                let across = [own, *across];
                Held::Thread(Thread {
                    axis,
                    across,
                    pitch,
                })
            }));
        }
        ([Part::Slide(_)], [axis, across @ ..]) => {
            let in_plane = ends.is_planar.then(|| graph.cross(units[2], *axis));
            for across in across.iter().copied().chain(in_plane) {
                all.push(Held::Across(turned(graph, across)));
            }
            all.extend(still(graph));
        }
        ([Part::Slide(_), Part::Slide(_), Part::Turn(_)], [normal, along @ ..]) => {
            all.push(Held::Across(turned(graph, *normal)));
            for along in along {
                all.push(Held::Between(turned(graph, *along), *normal));
            }
        }
        ([Part::Turn(0), Part::Turn(1)], [first, second, ..]) => {
            all.extend(places());
            all.push(Held::Between(turned(graph, *first), *second));
        }
        ([], _) => {
            all.extend(places());
            all.extend(still(graph));
        }
        _ => {}
    }
    all
}

/// A vector of the carried body, in the axes of the carrier, at zero coordinates.
fn at_zero(graph: &mut Graph, closing: &Closing, vector: Components) -> Components {
    // the last turn is that of the carried body
    closing
        .turned
        .iter()
        .rev()
        .fold(vector, |vector, (axis, angle)| {
            let cosine = graph.apply(Function::Cos, &[*angle]);
            let sine = graph.apply(Function::Sin, &[*angle]);
            let turning = Turning::about(graph, *axis, cosine, sine);
            let turned = turning.to_carrier(graph, vector);
            graph.quantities(turned)
        })
}

type Sides<'a> = (&'a Ends<'a>, [&'a Placed; 2], [Spot; 2]);

fn row(
    graph: &mut Graph,
    tree: &Tree,
    placed: &[Placed],
    (ends, sides, spots): Sides<'_>,
    held: Held,
    name: String,
) -> JointRow {
    let [carrier, carried] = sides;
    let difference = |graph: &mut Graph, part: fn(&Spot) -> Components| {
        let both = graph.subtract_vectors(part(&spots[1]), part(&spots[0]));
        graph.quantities(both)
    };
    let turning = |graph: &mut Graph, part: fn(&Placed) -> Components| {
        graph.subtract_vectors(part(carried), part(carrier))
    };
    let zeros = graph.zeros();
    let mut places = [spots[1].place; 2];
    let (value, rate, bias, force, moment) = match held {
        Held::Place(e) => {
            let [r, v, a] = [
                difference(graph, |spot| spot.place),
                difference(graph, |spot| spot.velocity),
                difference(graph, |spot| spot.acceleration),
            ];
            places = spots.map(|spot| spot.place);
            (graph.dot(e, r), graph.dot(e, v), graph.dot(e, a), e, zeros)
        }
        Held::Across(own) => {
            let e = carrier.to_world(graph, own);
            let [value, rate, bias] = along(graph, carrier, &spots, e);
            (value, rate, bias, e, zeros)
        }
        Held::Thread(thread) => {
            let e = carrier.to_world(graph, thread.axis);
            let moved = along(graph, carrier, &spots, e);
            let [value, rate, bias] = follow(graph, sides, &thread, (e, moved));
            let moment = graph.scale_vector(thread.pitch, e);
            (value, rate, bias, e, graph.negate_vector(moment))
        }
        Held::Between(own, other) => {
            let e = carrier.to_world(graph, own);
            let d = carried.to_world(graph, other);
            let n = graph.cross(d, e);
            let n = graph.quantities(n);
            let [w, alpha] = [
                turning(graph, |side| side.w),
                turning(graph, |side| side.alpha),
            ];
            let rate = graph.dot(w, n);
            let d_rate = graph.cross(carried.w, d);
            let e_rate = graph.cross(carrier.w, e);
            let first = graph.cross(d_rate, e);
            let second = graph.cross(d, e_rate);
            let n_rate = graph.add_vectors(first, second);
            let (turned, moved) = (graph.dot(alpha, n), graph.dot(w, n_rate));
            let bias = graph.add(turned, moved);
            // the angle at zero is that of the written directions
            let other = at_zero(graph, ends.closing, other);
            let start = graph.dot(own, other);
            let now = graph.dot(e, d);
            (graph.subtract(now, start), rate, bias, zeros, n)
        }
    };
    let [force, moment] = [force, moment].map(|vector| graph.quantities(vector));
    let slopes = slopes(graph, tree, placed, (ends, places), [force, moment]);
    let [value, rate, bias] = [value, rate, bias].map(|id| graph.quantity(id));
    JointRow {
        row: Row {
            name,
            value: Some(value),
            rate,
            bias,
            slopes,
            active: None,
        },
        force,
        moment,
    }
}

/// The distance of one spot from the other along a direction of the carrier, its rate, and its
/// second derivative.
fn along(graph: &mut Graph, carrier: &Placed, spots: &[Spot; 2], e: Components) -> [Id; 3] {
    let [r, v, a] = [
        (spots[1].place, spots[0].place),
        (spots[1].velocity, spots[0].velocity),
        (spots[1].acceleration, spots[0].acceleration),
    ]
    .map(|(end, start)| {
        let both = graph.subtract_vectors(end, start);
        graph.quantities(both)
    });
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

/// The same, minus what the thread advances by turning. The place counts up to whole turns:
///
/// ```text
/// 2 p tan((x / p - angle) / 2)        p: pitch, x: the place along the axis
/// ```
fn follow(
    graph: &mut Graph,
    [carrier, carried]: [&Placed; 2],
    thread: &Thread,
    (e, [place, rate, bias]): (Components, [Id; 3]),
) -> [Id; 3] {
    let w = graph.subtract_vectors(carried.w, carrier.w);
    let alpha = graph.subtract_vectors(carried.alpha, carrier.alpha);
    let swept = graph.cross(carrier.w, e);
    let (turned, moved) = (graph.dot(e, alpha), graph.dot(swept, w));
    let turning = [graph.dot(e, w), graph.add(turned, moved)];
    let [rate, bias] = [(rate, turning[0]), (bias, turning[1])].map(|(whole, turning)| {
        let part = graph.multiply(thread.pitch, turning);
        graph.subtract(whole, part)
    });
    let own = carrier.to_world(graph, thread.across[0]);
    let other = carried.to_world(graph, thread.across[1]);
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
    let one = graph.one();
    let cosine = graph.sum(&[one, third, fourth]);
    let tangent = graph.divide(sine, cosine);
    let twice = graph.add(thread.pitch, thread.pitch);
    [graph.multiply(twice, tangent), rate, bias]
}

/// The power of a force and a moment per rate of each open freedom: on the carried body, and with
/// the opposite sign on the carrier, each force at its place.
fn slopes(
    graph: &mut Graph,
    tree: &Tree,
    placed: &[Placed],
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
            // a freedom that carries both moves them alike
            if on == off {
                all.push(graph.zero());
                continue;
            }
            let own = &placed[index];
            let about = own.to_world(graph, freedom.twist.angular);
            let along = if link.is_free {
                freedom.twist.linear
            } else {
                own.to_world(graph, freedom.twist.linear)
            };
            let arm = graph.subtract_vectors(places[usize::from(on)], own.origin);
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
