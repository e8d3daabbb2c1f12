//! Accelerations, and the loads that the joints then transmit.

use super::Checks;
use crate::law::scene::{Carried, Loads};
use crate::law::space::{dot, scale, subtract};
use crate::wide::Wide;

impl Checks<'_> {
    /// By link, open and driven ones.
    pub fn by_link(&self, open: &[Wide]) -> Vec<Vec<Wide>> {
        let mut all = self.state.accelerations.clone();
        let mut open = open.iter().copied();
        for (joint, ids) in self.compiled.accelerations.iter().enumerate() {
            let link = self.compiled.links[joint];
            if !self.compiled.system.joints[joint].is_driven() {
                all[link] = open.by_ref().take(ids.len()).collect();
            }
        }
        all
    }

    /// The accelerations are those of a true motion, and the loads of joints those of it.
    pub fn motion(&mut self) -> Vec<Wide> {
        let compiled = self.compiled;
        let open = compiled.accelerations.concat();
        let found = self.values(&open);
        let mut accelerations = self.by_link(&found);
        self.loads = self.loads_in(&accelerations);
        let (loads, is_determined) = self.held(&mut accelerations);
        let (carried, _) = self.scene.carried(&loads, &accelerations);
        for (joint, link) in compiled.links.iter().enumerate() {
            let name = format!("j{link}");
            let along = &carried.along[*link];
            if compiled.system.joints[joint].is_driven() {
                if is_determined {
                    let driving = self.values(&compiled.driving[joint]);
                    self.close(&format!("drive of {name}"), &driving, along, carried.size);
                }
            } else {
                let drives = &loads.drives[*link];
                self.close(
                    &format!("acceleration of {name}"),
                    along,
                    drives,
                    carried.size,
                );
            }
        }
        if is_determined {
            self.reactions(&carried);
        }
        self.power(&loads, &carried, &accelerations);
        if self.drawn.rings.is_empty() {
            self.lagrange(&accelerations);
        }
        found
    }

    /// All loads with those that close loops, and whether these are determined.
    fn held(&mut self, accelerations: &mut [Vec<Wide>]) -> (Loads, bool) {
        let loops = self.drawn.loops();
        let mut loads = self.loads.clone();
        if loops.rings.is_empty() {
            return (loads, true);
        }
        let [left, size] = loops.closing(&self.state.rates, accelerations);
        let zero = [Wide::ZERO];
        self.close("opening of loops", &[left.into()], &zero, size);
        let (bare, _) = self.scene.carried(&loads, accelerations);
        let found = loops.holding(&self.state.rates, &bare.along, &loads);
        let forces = found.values.iter().map(|one| one.high.abs()).sum::<f64>();
        self.close(
            "motion of loops",
            &[found.left.into()],
            &zero,
            bare.size + forces,
        );
        loops.push(&self.scene.motions, &found, &mut loads);
        let is_determined = found.rank == loops.loads();
        if is_determined != self.compiled.reactions.is_some() {
            self.failures += "undetermined: reactions are, or are not\n";
            return (loads, false);
        }
        self.constraints();
        (loads, is_determined)
    }

    fn reactions(&mut self, carried: &Carried) {
        let compiled = self.compiled;
        let Some(reactions) = &compiled.reactions else {
            return;
        };
        for (link, tension) in &compiled.ties {
            let found = self.values(&[*tension]);
            let [force, moment] = carried.joints[*link];
            let along = dot(force, self.scene.along_rod(*link));
            let rest = subtract(force, scale(self.scene.along_rod(*link), along));
            let name = format!("tension of j{link}");
            self.close(&name, &found, &[along], carried.size);
            let nothing = [rest, moment].concat();
            self.close(&name, &nothing, &[Wide::ZERO; 6], carried.size);
        }
        let links = compiled.links.iter().chain(&compiled.closing);
        for (link, reaction) in links.zip(reactions) {
            let found = self.values(&reaction.concat());
            let expected = carried.joints[*link].concat();
            self.close(
                &format!("reaction of j{link}"),
                &found,
                &expected,
                carried.size,
            );
        }
    }

    /// What keeps loops closed is zero where they are, and changes as is said.
    fn constraints(&mut self) {
        let (compiled, state, drawn) = (self.compiled, self.state, self.drawn);
        let all = &compiled.constraints;
        let places: Vec<_> = all.iter().filter_map(|one| Some(one.position?.0)).collect();
        let rates: Vec<_> = all.iter().map(|one| one.velocity.0).collect();
        let zeros = vec![Wide::ZERO; all.len()];
        let sizes = state.rates.iter().flat_map(|(q, v)| q.iter().chain(v));
        let size = sizes.fold(10.0, |size, one| size + one.high.abs());
        let (place, rate) = (self.values(&places), self.values(&rates));
        self.close("constraint", &place, &zeros, size);
        self.close("constraint rate", &rate, &zeros, size * size);
        for (number, one) in all.iter().enumerate() {
            let direction = self.values(&one.direction);
            let long = direction.iter().map(|one| one.high.abs()).sum::<f64>() + 1.0;
            let mut parts = direction.iter().copied();
            let mut along = crate::law::scene::still(&drawn.links);
            for joint in &compiled.system.written {
                for part in &mut along[compiled.links[*joint]] {
                    *part = parts.next().unwrap_or(Wide::ZERO);
                }
            }
            let change = super::state::slope(long, |by| {
                let moved = state.shifted(drawn, &along, by);
                compiled.values(&places, &moved.given())
            });
            let coupling: Vec<_> = all.iter().map(|row| row.coupling[number]).collect();
            let coupling = self.values(&coupling);
            let long = direction.iter().map(|one| one.high.abs()).sum::<f64>() + 1.0;
            self.close(
                "constraint slope",
                &change,
                &coupling,
                size * long.powi(5) * 1e2,
            );
        }
    }
}
