//! The balances of absolute coordinates, `M x'' = f`, link by link. The motion of the origin of a
//! link has a column for each coordinate that moves it.

use crate::mechanics::tree::link::Tree;
use crate::mechanics::tree::regroup;
use crate::symbolic::{Components, Graph, Id};

use super::absolute::{Absolute, is_turn};
use super::arms::{Arms, ByArm, quarter_turn};
use super::shortest::Shortest;
use super::slopes::coriolis;

/// The motion of the origin of a link, in world axes.
#[derive(Clone, Default)]
struct OriginMotion {
    /// Its acceleration per unit acceleration of each coordinate.
    columns: Vec<(usize, Components)>,
    /// The remainder of its acceleration, minus that of free fall: vectors with factors.
    rest: Vec<(Id, Components)>,
    /// What it adds to the columns of its carrier.
    steps: Vec<(usize, Components)>,
}

/// The inertia of absolute coordinates, and the loads along them, without the drives of joints.
pub fn derive_masses(
    graph: &mut Graph,
    absolute: &Absolute,
    arms: &mut Arms<'_>,
    shortest: &Shortest,
) -> (Vec<Vec<Id>>, Vec<Id>) {
    let mut tree = shortest.tree.clone();
    let sides = vec![2; tree.links.len()];
    regroup(graph, &mut tree, &sides);
    let motions = motions(graph, absolute, arms, (&tree, &shortest.numbers));
    let zero = graph.zero();
    let mut balances = Balances {
        rows: vec![vec![zero; absolute.count]; absolute.count],
        driving: vec![zero; absolute.count],
    };
    for (index, moving) in motions.iter().enumerate() {
        let (own, number) = (&tree.links[index].properties, shortest.numbers[index]);
        let first = arms.by_arm(graph, number, own.first);
        let link = Inert {
            mass: own.mass,
            first,
            inertia: own.inertia[2][2],
            turns: absolute.turns[number],
            square: absolute.squares[number],
            given: absolute.given[number],
        };
        balances.add(graph, &link, moving);
    }
    // each link passes its loads on to its carrier
    let mut forces = vec![graph.zeros(); tree.links.len()];
    for (index, link) in tree.links.iter().enumerate().rev() {
        let number = shortest.numbers[index];
        let own = arms.world(graph, number, link.force);
        let whole = graph.add_vectors(forces[index], own);
        for (coordinate, step) in &motions[index].steps {
            let part = graph.dot(*step, whole);
            balances.drive(graph, *coordinate, part);
        }
        if let Some(turns) = absolute.turns[number] {
            balances.drive(graph, turns, link.moment[2]);
        }
        if let Some(carrier) = link.carrier {
            forces[carrier] = graph.add_vectors(forces[carrier], whole);
        }
    }
    let rows = balances.rows.into_iter();
    let rows = rows.map(|row| row.into_iter().map(|one| graph.quantity(one)).collect());
    (rows.collect(), balances.driving)
}

fn motions(
    graph: &mut Graph,
    absolute: &Absolute,
    arms: &mut Arms<'_>,
    (tree, numbers): (&Tree, &[usize]),
) -> Vec<OriginMotion> {
    let mut all: Vec<OriginMotion> = Vec::new();
    let one = graph.one();
    let fall = graph.negate_vector(tree.gravity);
    for (index, link) in tree.links.iter().enumerate() {
        let number = numbers[index];
        let (mut rest, mut steps) = (vec![(one, fall)], Vec::new());
        let mut columns = Vec::new();
        if let Some(carrier) = link.carrier {
            let below = numbers[carrier];
            let arm = arms.world(graph, below, link.place);
            let swept = quarter_turn(graph, arm);
            rest.clone_from(&all[carrier].rest);
            columns.clone_from(&all[carrier].columns);
            rest.push((graph.negate(absolute.squares[below]), arm));
            rest.push((absolute.given[below], swept));
            steps.extend(absolute.turns[below].map(|own| (own, swept)));
        }
        let mut next = absolute.first[number];
        for freedom in &link.freedoms {
            let own = next;
            next += usize::from(freedom.given.is_none());
            if is_turn(graph, freedom) {
                continue;
            }
            let along = if link.is_free {
                freedom.twist.linear
            } else {
                arms.world(graph, number, freedom.twist.linear)
            };
            match freedom.given {
                Some(rate) => rest.push((rate, along)),
                None => steps.push((own, along)),
            }
            if !link.is_free {
                let bent = coriolis(graph, arms.turning_rate(number), freedom.rate, along);
                rest.push((one, bent));
            }
        }
        for (coordinate, step) in &steps {
            let mut known = columns.iter_mut();
            match known.find(|(own, _)| own == coordinate) {
                Some((_, column)) => *column = graph.add_vectors(*column, *step),
                None => columns.push((*coordinate, *step)),
            }
        }
        rest.retain(|(factor, vector)| !graph.is_zero(*factor) && !graph.is_zero_vector(vector));
        all.push(OriginMotion {
            columns,
            rest,
            steps,
        });
    }
    all
}

/// The inertia of a link about its origin, and the coordinate of its rotation.
struct Inert {
    mass: Id,
    first: ByArm,
    inertia: Id,
    turns: Option<usize>,
    square: Id,
    given: Id,
}

struct Balances {
    rows: Vec<Vec<Id>>,
    driving: Vec<Id>,
}

impl Balances {
    fn couple(&mut self, graph: &mut Graph, (i, j): (usize, usize), part: Id) {
        self.rows[i][j] = graph.add(self.rows[i][j], part);
        self.rows[j][i] = self.rows[i][j];
    }

    fn drive(&mut self, graph: &mut Graph, coordinate: usize, part: Id) {
        self.driving[coordinate] = graph.add(self.driving[coordinate], part);
    }

    /// Adds the balances of the momentum, `m v + x z x s`, and of the angular momentum about the
    /// origin, `x I + s x v`.
    fn add(&mut self, graph: &mut Graph, link: &Inert, moving: &OriginMotion) {
        for (place, (i, column)) in moving.columns.iter().enumerate() {
            for (j, other) in &moving.columns[..=place] {
                let product = graph.dot(*column, *other);
                let part = graph.multiply(link.mass, product);
                self.couple(graph, (*i, *j), part);
            }
            if let Some(turns) = link.turns {
                let part = link.first.cross(graph, *column);
                self.couple(graph, (turns, *i), part);
                if turns == *i {
                    self.couple(graph, (turns, turns), part);
                }
            }
            // the centripetal part w^2 s is subtracted from the force
            let swung = link.first.dot(graph, *column);
            let part = graph.multiply(link.square, swung);
            self.drive(graph, *i, part);
            let turned = link.first.cross(graph, *column);
            let part = graph.multiply(link.given, turned);
            let part = graph.negate(part);
            self.drive(graph, *i, part);
            for (factor, vector) in &moving.rest {
                let along = graph.dot(*column, *vector);
                let force = graph.multiply(link.mass, *factor);
                let part = graph.multiply(force, along);
                let part = graph.negate(part);
                self.drive(graph, *i, part);
            }
        }
        let Some(turns) = link.turns else { return };
        self.couple(graph, (turns, turns), link.inertia);
        let mut taken = graph.multiply(link.inertia, link.given);
        for (factor, vector) in &moving.rest {
            let lever = link.first.cross(graph, *vector);
            let part = graph.multiply(*factor, lever);
            taken = graph.add(taken, part);
        }
        let part = graph.negate(taken);
        self.drive(graph, turns, part);
    }
}
