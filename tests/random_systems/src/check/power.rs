//! The power of the loads, compared with the changes of energies.

use super::Checks;
use super::state::{State, slope};
use crate::law::scene::{Carried, Loads, Scene};
use crate::law::space::dot;
use crate::wide::Wide;

impl Checks<'_> {
    /// Kinetic energy changes by the power of all loads, and that of potentials by theirs.
    pub fn power(&mut self, loads: &Loads, carried: &Carried, accelerations: &[Vec<Wide>]) {
        let (drawn, compiled, state) = (self.drawn, self.compiled, self.state);
        let links = (&drawn.links[..], drawn.bodies());
        let moved = |by: f64| state.later(drawn, accelerations, by);
        let fast = state.rates.iter().flat_map(|(_, v)| v);
        let fast = fast.fold(1.0, |fast: f64, v| fast.max(v.high.abs()));
        let bent = accelerations.iter().flatten();
        let bent = bent.fold(1.0, |bent: f64, a| bent.max(a.high.abs()));
        let pace = fast + bent.sqrt();
        let kinetic = [compiled.energy.kinetic];
        let change = slope(pace, |by| compiled.values(&kinetic, &moved(by).given()));
        let (mut power, mut size) = self.done(loads);
        for (link, (_, v)) in drawn
            .links
            .iter()
            .zip(&state.rates)
            .enumerate()
            .map(|(i, (l, r))| ((i, l), r))
        {
            let (number, link) = link;
            if link.driven.is_some() {
                for (along, v) in carried.along[number].iter().zip(v) {
                    power = power + *along * *v;
                    size += (*along * *v).high.abs();
                }
            }
        }
        // what differences cut off
        let loose = 1e3 * pace;
        self.close("power", &change, &[power], (size + carried.size) * loose);
        let stored = |state: &State| -> Wide {
            let scene = Scene::new(links, state.instant(drawn), &state.rates);
            drawn.stored.iter().map(|energy| energy(&scene)).sum()
        };
        let by_time = |by: f64| {
            let mut later = state.later(drawn, accelerations, 0.0);
            later.time = state.time + Wide::from(by);
            vec![stored(&later)]
        };
        let change = slope(pace, |by| vec![stored(&moved(by))]);
        let in_time = slope(pace, by_time);
        let pulling = self.scene.loads(drawn.pulling.iter());
        let (power, size) = self.done(&pulling);
        self.close(
            "power of potentials",
            &change,
            &[in_time[0] - power],
            (size + 1.0) * loose,
        );
    }

    /// The power of loads on bodies and along freedoms, and of what size.
    fn done(&self, loads: &Loads) -> (Wide, f64) {
        let (mut power, mut size) = (Wide::ZERO, 0.0);
        let mut add = |part: Wide| {
            power = power + part;
            size += part.high.abs();
        };
        for ([force, moment], motion) in loads.on.iter().zip(&self.scene.motions) {
            add(dot(*force, motion.velocity));
            add(dot(*moment, motion.angular_velocity));
        }
        for (drives, (_, v)) in loads.drives.iter().zip(&self.state.rates) {
            for (drive, v) in drives.iter().zip(v) {
                add(*drive * *v);
            }
        }
        (power, size)
    }
}
