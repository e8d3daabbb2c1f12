//! Absolute coordinates: for each open rotational coordinate, the angle of its link in the world;
//! for any other, the coordinate itself.

use crate::mechanics::tree::link::{Freedom, Link, Tree};
use crate::symbolic::{Graph, Id};

use super::super::constraints::Placed;

/// The coordinates that rotate the links of a tree. Links that are welded to their carriers rotate
/// with them.
pub struct Absolute {
    /// The coordinate that is the angle of each link; `None` if its rotation is known.
    pub turns: Vec<Option<usize>>,
    /// The angular acceleration of each link, without that of its coordinate.
    pub given: Vec<Id>,
    /// The square of the angular velocity of each link.
    pub squares: Vec<Id>,
    /// The first coordinate of each link.
    pub first: Vec<usize>,
    pub count: usize,
    /// For each hinge: its coordinate, and the link that carries it.
    hinges: Vec<(usize, usize)>,
}

/// Whether a freedom rotates the carried links.
pub fn is_turn(graph: &Graph, freedom: &Freedom) -> bool {
    !graph.is_zero_vector(&freedom.twist.angular)
}

impl Absolute {
    pub fn of(graph: &mut Graph, tree: &Tree, placed: &[Placed]) -> Self {
        let zero = graph.zero();
        let mut found = Self {
            turns: Vec::new(),
            given: Vec::new(),
            squares: Vec::new(),
            first: Vec::new(),
            count: 0,
            hinges: Vec::new(),
        };
        for (link, placed) in tree.links.iter().zip(placed) {
            let mut turns = link.carrier.and_then(|carrier| found.turns[carrier]);
            let mut given = link.carrier.map_or(zero, |carrier| found.given[carrier]);
            found.first.push(found.count);
            for freedom in &link.freedoms {
                let is_turn = is_turn(graph, freedom);
                match freedom.given {
                    Some(rate) if is_turn => given = graph.add(given, rate),
                    Some(_) => {}
                    None => {
                        if is_turn {
                            if let Some(carrier) = link.carrier {
                                found.hinges.push((found.count, carrier));
                            }
                            (turns, given) = (Some(found.count), zero);
                        }
                        found.count += 1;
                    }
                }
            }
            let square = graph.square(placed.w[2]);
            found.turns.push(turns);
            found.given.push(graph.quantity(given));
            found.squares.push(graph.quantity(square));
        }
        found
    }

    /// Loads along joint coordinates, turned into loads along absolute ones: `T^T u`.
    pub fn gathered(&self, graph: &mut Graph, of_joints: &[Id]) -> Vec<Id> {
        let mut all = of_joints.to_vec();
        for (own, carrier) in &self.hinges {
            if let Some(below) = self.turns[*carrier] {
                all[below] = graph.subtract(all[below], of_joints[*own]);
            }
        }
        all
    }

    /// The accelerations of joint coordinates, `T x - d`.
    pub fn of_joints(&self, graph: &mut Graph, absolute: &[Id]) -> Vec<Id> {
        let mut all = absolute.to_vec();
        for (own, carrier) in &self.hinges {
            let below = self.turns[*carrier].map(|below| absolute[below]);
            for part in below.into_iter().chain([self.given[*carrier]]) {
                all[*own] = graph.subtract(all[*own], part);
            }
        }
        all
    }

    /// Adds the loads of armatures J along the coordinates of joints: `T^T J (T x - d)`.
    pub fn add_armatures(
        &self,
        graph: &mut Graph,
        tree: &Tree,
        (masses, driving): (&mut [Vec<Id>], &mut [Id]),
    ) {
        for (own, freedom) in tree.links.iter().flat_map(Link::open).enumerate() {
            let armature = freedom.armature;
            masses[own][own] = graph.add(masses[own][own], armature);
            let hinge = self.hinges.iter().find(|(hinge, _)| *hinge == own);
            let Some((_, carrier)) = hinge else { continue };
            let known = graph.multiply(armature, self.given[*carrier]);
            driving[own] = graph.add(driving[own], known);
            if let Some(below) = self.turns[*carrier] {
                driving[below] = graph.subtract(driving[below], known);
                masses[below][below] = graph.add(masses[below][below], armature);
                for (row, column) in [(own, below), (below, own)] {
                    masses[row][column] = graph.subtract(masses[row][column], armature);
                }
            }
        }
    }

    /// `u . d`
    pub fn known(&self, graph: &mut Graph, of_joints: &[Id]) -> Id {
        let hinges = self.hinges.iter();
        let parts: Vec<Id> = hinges
            .map(|(own, carrier)| graph.multiply(of_joints[*own], self.given[*carrier]))
            .collect();
        graph.sum(&parts)
    }
}
