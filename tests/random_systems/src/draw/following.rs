//! Loads that depend on accelerations.

use super::Drawing;
use super::number::literal;
use crate::law::space::{Vec3, dot, scale};
use crate::wide::Wide;

impl Drawing {
    /// Mass at a point, alike in all directions or along one of the body or the world, or inertia
    /// against turning.
    pub fn added_to(&mut self, body: usize) {
        let k = self.numbers.positive(1.0);
        let (point, place) = self.point_of(body);
        let (which, axis) = (self.numbers.rng.usize(0..4), self.numbers.rng.usize(0..2));
        if !self.is_kept() {
            return;
        }
        let (follows, at) = if point == "G" {
            ("acceleration".to_owned(), String::new())
        } else {
            (format!("{point}.acceleration()"), format!(".at({point})"))
        };
        self.following += 1;
        let unit = if which == 2 { "kg * m ^ 2" } else { "kg" };
        // what else is drawn does not depend on it
        let is_param = self.numbers.params > 0 && self.numbers.rng.clone().bool();
        let k_word = if is_param {
            self.numbers.param(k, unit)
        } else {
            format!("{}[{unit}]", literal(k))
        };
        let parts = if axis == 0 { ["1", "0"] } else { ["0", "1"] };
        let frame = if which == 3 { "world" } else { "body" };
        let along = format!(
            "{frame}({}{})",
            parts.join(", "),
            if self.is_planar { "" } else { ", 0" }
        );
        let keys = self.keys(body);
        match which {
            0 => keys
                .forces
                .push(format!("added = (-{k_word} * {follows}){at}")),
            1 | 3 => keys.forces.push(format!(
                "added = (-{k_word} * {along} * {follows}.dot({along})){at}"
            )),
            _ => keys
                .moments
                .push(format!("added = -{k_word} * angular_acceleration")),
        }
        let all = self.alike_as(body);
        self.act(
            true,
            Box::new(move |scene, loads| {
                for body in &all {
                    let [linear, turning] = scene.followed(*body, place);
                    let against = |vector: Vec3| scale(vector, (-k).into());
                    if which == 2 {
                        loads.moment(*body, against(turning));
                        continue;
                    }
                    let mut force = against(linear);
                    if which != 0 {
                        let mut unit = [Wide::ZERO; 3];
                        unit[axis] = Wide::ONE;
                        let in_body = Some(*body).filter(|_| which == 1);
                        let along = scene.turned(in_body, unit);
                        force = scale(along, dot(force, along));
                    }
                    loads.force(scene, *body, place, force);
                }
            }),
        );
    }
}
