//! Regressors: the loads of a motion along its freedoms, per inertial parameter of each body.

use fastrand::Rng;

use super::Checks;
use crate::law::kind::Motion;
use crate::law::scene::Loads;
use crate::law::space::{
    Mat3, Vec3, add, apply, cross, crossing, product, scale, subtract, sum, times, transposed,
};
use crate::wide::Wide;

/// The parameters of a body in the plane, among all.
const PLANAR: [usize; 4] = [0, 1, 2, 6];

/// Mass, first moment and inertia of a body about the point that its joint holds, body axes.
struct Parameters {
    mass: Wide,
    moment: Vec3,
    inertia: Mat3,
}

impl Parameters {
    fn list(&self, is_planar: bool) -> Vec<Wide> {
        let [xx, yy, zz] = [0, 1, 2].map(|i| self.inertia[i][i]);
        let products = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| self.inertia[i][j]);
        let [x, y, z] = self.moment;
        let [xy, yz, zx] = products;
        let all = [self.mass, x, y, z, xx, yy, zz, xy, yz, zx];
        if is_planar {
            PLANAR.map(|number| all[number]).to_vec()
        } else {
            all.to_vec()
        }
    }
}

/// `h^2 1 - h h`
fn about(h: Vec3) -> Mat3 {
    let cross = crossing(h);
    times(&product(&cross, &cross), -Wide::ONE)
}

impl Checks<'_> {
    /// Of each body its parameters, and what the motion takes of any others in their place.
    pub fn regressed(&mut self, rng: &mut Rng) {
        let (compiled, drawn) = (self.compiled, self.drawn);
        let (Some(regressors), Some(gravity)) = (&compiled.regressors, drawn.gravity) else {
            return;
        };
        let none = self.scene.loads(core::iter::empty());
        let (_, motions) = self.scene.carried(&none, &self.state.accelerations);
        for (regressor, link) in regressors.iter().zip(&compiled.links) {
            let own = &drawn.links[*link];
            let offset = scale(own.pin, -Wide::ONE);
            let true_ones = Parameters {
                mass: own.mass,
                moment: scale(offset, own.mass),
                inertia: sum(&own.inertia, &times(&about(offset), own.mass)),
            };
            let found = self.values(&regressor.parameters);
            let expected = true_ones.list(drawn.is_planar);
            self.close(&format!("parameters of b{link}"), &found, &expected, 0.0);
            let mut number = || Wide::from(rng.f64() * 2.0 - 1.0);
            let [[xx, yy, zz], [xy, yz, zx]] = [0, 1].map(|_| [0, 1, 2].map(|_| number()));
            let moment = [0, 1, 2].map(|_| number());
            let mut others = Parameters {
                mass: number(),
                moment,
                inertia: [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]],
            };
            if drawn.is_planar {
                others.moment[2] = Wide::ZERO;
                others.inertia = times(
                    &crate::law::space::diagonal([Wide::ZERO, Wide::ZERO, Wide::ONE]),
                    zz,
                );
            }
            let columns = self.values(&regressor.columns.concat());
            let list = others.list(drawn.is_planar);
            let rows = columns.len() / list.len();
            let found = (0..rows).map(|row| {
                let terms = list.iter().enumerate();
                terms
                    .map(|(at, one)| columns[at * rows + row] * *one)
                    .sum::<Wide>()
            });
            let found: Vec<Wide> = found.collect();
            let falls = drawn.falls.iter().filter(|(body, _)| body == link);
            let fall = falls.fold(gravity, |all, (_, fall)| add(all, *fall));
            let (expected, size) = self.taken_of(&others, *link, (&motions, fall));
            self.close(&format!("regressor of b{link}"), &found, &expected, size);
        }
    }

    /// What the motion takes of these parameters of a body along all freedoms, and nothing of the
    /// others: these carry loads that move them.
    fn taken_of(
        &self,
        parameters: &Parameters,
        link: usize,
        (motions, fall): (&[Motion], Vec3),
    ) -> (Vec<Wide>, f64) {
        let motion = &motions[link];
        let (w, turning) = (motion.angular_velocity, motion.angular_acceleration);
        let arm = self.scene.turned(Some(link), self.drawn.links[link].pin);
        let swept = add(cross(turning, arm), cross(w, cross(w, arm)));
        let at_pin = subtract(add(motion.acceleration, swept), fall);
        let h = self.scene.turned(Some(link), parameters.moment);
        let attitude = &motion.attitude;
        let tensor = product(
            &product(attitude, &parameters.inertia),
            &transposed(attitude),
        );
        let thrown = add(cross(turning, h), cross(w, cross(w, h)));
        let force = add(scale(at_pin, parameters.mass), thrown);
        let spun = add(apply(&tensor, turning), cross(w, apply(&tensor, w)));
        let moment = add(spun, cross(h, at_pin));
        let mut loads = Loads {
            on: (0..self.drawn.links.len())
                .map(|other| self.scene.taken(other, &motions[other]))
                .collect(),
            ..self.scene.loads(core::iter::empty())
        };
        let [sum, about] = loads.on[link];
        let about_center = add(moment, cross(arm, force));
        loads.on[link] = [subtract(sum, force), subtract(about, about_center)];
        let (carried, _) = self.scene.carried(&loads, &self.state.accelerations);
        // rotors along freedoms belong to no body
        let own = |joint: usize| {
            let link = &self.drawn.links[joint];
            let pairs = carried.along[joint]
                .iter()
                .zip(&self.state.accelerations[joint]);
            pairs
                .map(|(along, a)| *along - link.armature * *a)
                .collect::<Vec<_>>()
        };
        let written = self.compiled.system.written.iter();
        let all = written.flat_map(|joint| own(self.compiled.links[*joint]));
        (all.collect(), carried.size)
    }
}
