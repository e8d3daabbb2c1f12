//! The directions held by a joint that closes a loop, one by one.

use crate::mechanics::tree::turning::Turning;
use crate::model::{Connection, Part};
use crate::symbolic::{Components, Function, Graph, Id};

/// A held direction, which is one constraint.
#[derive(Clone, Copy)]
pub enum Held {
    /// The place of the point of the carried body, along a direction of the world.
    Place(Components),
    /// The same, along a direction that is fixed in the carrier.
    Across(Components),
    /// The angle between a direction of the carrier and one of the carried body.
    Between([Components; 2], Facing),
    /// The place along a direction that is fixed in the carrier, which the angle about it
    /// determines.
    Thread(Thread),
}

/// A direction of the carrier and one of the carried body that agree in the assembly that is meant.
/// Held angles alone allow others too, such as a reversed axis. `None` if nothing can be reversed.
pub type Facing = Option<[Components; 2]>;

/// The thread of a screw.
#[derive(Clone, Copy)]
pub struct Thread {
    pub axis: Components,
    /// Two directions across the axis that agree at zero coordinates, one of the carrier and one of
    /// the carried body.
    pub across: [Components; 2],
    /// Meters per radian.
    pub pitch: Id,
}

/// The directions that a joint holds.
pub fn held(graph: &mut Graph, closing: &Connection, is_planar: bool) -> Vec<Held> {
    if is_planar {
        in_plane(graph, closing)
    } else {
        in_space(graph, closing)
    }
}

fn in_plane(graph: &mut Graph, closing: &Connection) -> Vec<Held> {
    let [x, y, z] = graph.unit_vectors();
    let pin = [Held::Place(x), Held::Place(y)];
    let still = |graph: &mut Graph| {
        let of_carrier = at_zero(graph, closing, x);
        Held::Between([of_carrier, y], Some([of_carrier, x]))
    };
    match (closing.kind.parts, closing.directions.as_slice()) {
        ([Part::Turn(_)], _) => pin.to_vec(),
        ([Part::Slide(_), Part::Turn(_)], [along, normal]) => {
            let across = graph.cross(*normal, *along);
            vec![Held::Across(at_zero(graph, closing, across))]
        }
        ([Part::Slide(_)], [along, ..]) => {
            let across = graph.cross(z, *along);
            let across = at_zero(graph, closing, across);
            vec![Held::Across(across), still(graph)]
        }
        ([], _) => [&pin[..], &[still(graph)]].concat(),
        _ => Vec::new(),
    }
}

fn in_space(graph: &mut Graph, closing: &Connection) -> Vec<Held> {
    let units = graph.unit_vectors();
    let ball = units.map(Held::Place);
    let turned = |graph: &mut Graph, vector: Components| at_zero(graph, closing, vector);
    let across = |graph: &mut Graph, one: Components| Held::Across(turned(graph, one));
    // `one` and `other` keep their angle, and `facing` its direction
    let between = |graph: &mut Graph, [one, other]: [Components; 2], facing| {
        Held::Between(
            [turned(graph, one), other],
            Some([turned(graph, facing), facing]),
        )
    };
    // no direction of one body rotates relative to the other body
    let still = |graph: &mut Graph| {
        [(0, 1), (1, 2), (2, 0)].map(|(i, j)| between(graph, [units[i], units[j]], units[i]))
    };
    let mut all = Vec::new();
    match (closing.kind.parts, closing.directions.as_slice()) {
        ([Part::Ball], _) => all.extend(ball),
        ([Part::Turn(_)], [axis, normals @ ..]) => {
            all.extend(ball);
            let normals = normals.iter();
            all.extend(normals.map(|normal| between(graph, [*normal, *axis], *axis)));
        }
        ([Part::Slide(_), Part::Turn(_)] | [Part::Screw], [axis, normals @ ..]) => {
            for normal in normals {
                let tilt = between(graph, [*normal, *axis], *axis);
                all.extend([across(graph, *normal), tilt]);
            }
            let first = normals.iter().zip(closing.pitch).next();
            all.extend(first.map(|(normal, pitch)| {
                let (axis, own) = (turned(graph, *axis), turned(graph, *normal));
                let across = [own, *normal];
                Held::Thread(Thread {
                    axis,
                    across,
                    pitch,
                })
            }));
        }
        ([Part::Slide(_)], [_, normals @ ..]) => {
            all.extend(normals.iter().map(|normal| across(graph, *normal)));
            all.extend(still(graph));
        }
        ([Part::Slide(_), Part::Slide(_), Part::Turn(_)], [normal, along @ ..]) => {
            all.push(across(graph, *normal));
            let along = along.iter();
            all.extend(along.map(|along| between(graph, [*along, *normal], *normal)));
        }
        ([Part::Turn(0), Part::Turn(1)], [first, second, ..]) => {
            all.extend(ball);
            let first = turned(graph, *first);
            all.push(Held::Between([first, *second], None));
        }
        ([], _) => {
            all.extend(ball);
            all.extend(still(graph));
        }
        _ => {}
    }
    all
}

/// A vector of the carried body, in the axes of the carrier at zero coordinates.
pub fn at_zero(graph: &mut Graph, closing: &Connection, vector: Components) -> Components {
    // the last rotation is the innermost, that of the carried body
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
