//! Loops. A joint that closes one carries a massless link at the place of the body. The coordinates
//! of such joints are unknowns like those of the tree, and a load with all components holds the
//! body and the link together.

use super::kind::{Motion, Rates, vector_of};
use super::linear::{self, Solution};
use super::scene::{Link, Loads, Ring, motions, still};
use super::space::{Vec3, add, apply, cross, product, scale, size, subtract, transposed};
use crate::wide::Wide;

/// The links of a system with its loops.
#[derive(Clone, Copy)]
pub struct Loops<'a> {
    pub links: &'a [Link],
    pub rings: &'a [Ring],
    pub is_planar: bool,
}

/// Closed is what is apart by less.
const CLOSED: f64 = 1e-28;

impl Loops<'_> {
    /// The components that there are of a velocity and an angular velocity.
    fn axes(&self) -> &'static [usize] {
        if self.is_planar {
            &[0, 1, 5]
        } else {
            &[0, 1, 2, 3, 4, 5]
        }
    }

    /// The freedoms that are not prescribed: the link, and which of its own.
    pub fn open(&self) -> Vec<(usize, usize)> {
        let links = self.links.iter().enumerate();
        let links = links.filter(|(_, link)| link.driven.is_none());
        links
            .flat_map(|(number, link)| (0..link.kind.freedoms()).map(move |one| (number, one)))
            .collect()
    }

    fn arms(&self, ring: &Ring, motions: &[Motion]) -> [Vec3; 2] {
        [ring.body, ring.link].map(|link| {
            // both have Q in the same place of their axes
            apply(&motions[link].attitude, self.links[ring.link].pin)
        })
    }

    /// How the bodies move against the links, at Q: rates, and accelerations.
    fn against(&self, motions: &[Motion]) -> [Vec<Wide>; 2] {
        let mut all = [Vec::new(), Vec::new()];
        for ring in self.rings {
            let [arm, other] = self.arms(ring, motions);
            let both = motions[ring.body].against(arm, &motions[ring.link], other);
            for (list, parts) in all.iter_mut().zip(both) {
                let parts = parts.concat();
                list.extend(self.axes().iter().map(|axis| parts[*axis]));
            }
        }
        all
    }

    /// How far bodies are from the links.
    fn gaps(&self, motions: &[Motion]) -> Vec<Wide> {
        let mut all = Vec::new();
        for ring in self.rings {
            let [body, link] = [&motions[ring.body], &motions[ring.link]];
            let [arm, other] = self.arms(ring, motions);
            let apart = subtract(add(body.position, arm), add(link.position, other));
            let turn = product(&body.attitude, &transposed(&link.attitude));
            let parts = [apart, vector_of(&turn)].concat();
            all.extend(self.axes().iter().map(|axis| parts[*axis]));
        }
        all
    }

    /// The rates of bodies against links, by those of the open freedoms: a row each.
    pub fn slopes(&self, rates: &[Rates]) -> Vec<Vec<Wide>> {
        let slow = rates.iter();
        let slow = slow.map(|(q, v)| (q.clone(), vec![Wide::ZERO; v.len()]));
        let slow: Vec<Rates> = slow.collect();
        let mut unit = still(self.links);
        let mut columns = Vec::new();
        for (link, freedom) in self.open() {
            unit[link][freedom] = Wide::ONE;
            let [_, accelerations] = self.against(&motions(self.links, &slow, &unit));
            columns.push(accelerations);
            unit[link][freedom] = Wide::ZERO;
        }
        transpose(&columns, self.axes().len() * self.rings.len())
    }

    /// Moves the open coordinates until all loops are closed, and then the rates; none if they do not
    /// close.
    pub fn assembled(&self, mut rates: Vec<Rates>) -> Option<Vec<Rates>> {
        let still = still(self.links);
        for _ in 0..40 {
            let gaps = self.gaps(&motions(self.links, &rates, &still));
            let apart = gaps
                .iter()
                .fold(0.0, |most: f64, gap| most.max(gap.high.abs()));
            if apart < CLOSED {
                let [moving, _] = self.against(&motions(self.links, &rates, &still));
                let by = self.shares(&linear::solve(self.slopes(&rates), negative(&moving)));
                for ((_, v), by) in rates.iter_mut().zip(by) {
                    for (v, by) in v.iter_mut().zip(by) {
                        *v = *v + by;
                    }
                }
                let [moving, _] = self.against(&motions(self.links, &rates, &still));
                let fast = moving
                    .iter()
                    .fold(0.0, |most: f64, one| most.max(one.high.abs()));
                return (fast < CLOSED * 1e3).then_some(rates);
            }
            // a step that leads far away leads nowhere
            let step = linear::solve(self.slopes(&rates), negative(&gaps));
            if step.values.iter().any(|one| one.high.abs() > 2.0) {
                return None;
            }
            let by = self.shares(&step);
            for ((link, (q, _)), by) in self.links.iter().zip(&mut rates).zip(by) {
                *q = link.kind.moved(q, &by);
            }
        }
        None
    }

    /// What is found of the open freedoms, link by link.
    fn shares(&self, found: &Solution) -> Vec<Vec<Wide>> {
        let mut all = still(self.links);
        for ((link, freedom), value) in self.open().into_iter().zip(&found.values) {
            all[link][freedom] = *value;
        }
        all
    }

    /// Gives the joints that close loops their accelerations: what is left of the loops' own
    /// accelerations, of what size.
    pub fn closing(&self, rates: &[Rates], accelerations: &mut [Vec<Wide>]) -> [f64; 2] {
        let [_, bent] = self.against(&motions(self.links, rates, accelerations));
        let own: Vec<usize> = self.rings.iter().map(|ring| ring.link).collect();
        let open = self.open();
        let columns = || (0..open.len()).filter(|column| own.contains(&open[*column].0));
        let rows = self.slopes(rates);
        let rows: Vec<Vec<Wide>> = rows
            .iter()
            .map(|row| columns().map(|column| row[column]).collect())
            .collect();
        let found = linear::solve(rows.clone(), negative(&bent));
        for (column, value) in columns().zip(&found.values) {
            let (link, freedom) = open[column];
            accelerations[link][freedom] = *value;
        }
        let left = linear::times(&rows, &found.values);
        let left = left.iter().zip(&bent);
        let left = left.fold(0.0, |most: f64, (a, b)| most.max((*a + *b).high.abs()));
        let motions = motions(self.links, rates, accelerations);
        let sizes = motions.iter().map(|motion| {
            let rate = size(motion.angular_velocity);
            size(motion.acceleration) + size(motion.angular_acceleration) + rate * rate
        });
        [left, 1.0 + sizes.sum::<f64>()]
    }

    /// The loads that hold bodies and links together, with which what joints carry along their open
    /// freedoms is what drives them.
    pub fn holding(&self, rates: &[Rates], along: &[Vec<Wide>], loads: &Loads) -> Solution {
        let rows = self.slopes(rates);
        let open = self.open();
        let missing = open
            .iter()
            .map(|(link, freedom)| along[*link][*freedom] - loads.drives[*link][*freedom]);
        let missing = missing.collect();
        linear::solve(transpose(&rows, open.len()), missing)
    }

    /// Puts these loads on bodies and links.
    pub fn push(&self, motions: &[Motion], found: &Solution, loads: &mut Loads) {
        let axes = self.axes();
        for (number, ring) in self.rings.iter().enumerate() {
            let mut parts = [Wide::ZERO; 6];
            for (axis, value) in axes.iter().zip(&found.values[number * axes.len()..]) {
                parts[*axis] = *value;
            }
            let [fx, fy, fz, mx, my, mz] = parts;
            let (force, moment) = ([fx, fy, fz], [mx, my, mz]);
            let arms = self.arms(ring, motions);
            for ((link, arm), sign) in [ring.body, ring.link]
                .into_iter()
                .zip(arms)
                .zip([Wide::ONE, -Wide::ONE])
            {
                let about = add(moment, cross(arm, force));
                let [on, sum] = loads.on[link];
                loads.on[link] = [add(on, scale(force, sign)), add(sum, scale(about, sign))];
            }
        }
    }

    /// As many unknown loads as there are.
    pub fn loads(&self) -> usize {
        self.rings.len() * self.axes().len()
    }
}

fn negative(list: &[Wide]) -> Vec<Wide> {
    list.iter().map(|one| -*one).collect()
}

/// Rows from columns, of so many.
fn transpose(columns: &[Vec<Wide>], count: usize) -> Vec<Vec<Wide>> {
    (0..count)
        .map(|row| columns.iter().map(|column| column[row]).collect())
        .collect()
}
