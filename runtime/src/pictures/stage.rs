//! Moving solids: elements, and the frames of their motion.

use std::fmt::Write as _;
use std::string::String;
use std::vec::Vec;

use nalgebra::{UnitQuaternion, Vector3};

use super::faces;
use super::markup::{COLORS, short};
use super::plot::path;
use super::pose::Pose;
use super::solid::Solid;
use super::view::View;

/// The size of the stage, and its margin, in pixels.
pub(super) const WIDTH: f64 = 720.0;
pub(super) const HEIGHT: f64 = 420.0;
const MARGIN: f64 = 24.0;

/// The maximum number of frames of a motion. Places and attitudes are interpolated between frames.
const FRAMES: usize = 600;
/// A fraction of the duration that is too short to be noticed \[%\].
const BESIDE: f64 = 1e-3;

/// A solid, and where it is at each sample.
#[derive(Clone, Debug)]
pub(super) struct Actor {
    pub(super) solid: Solid,
    pub(super) poses: Vec<Pose>,
}

/// Solids in motion.
pub(super) struct Stage<'p> {
    pub(super) actors: &'p [Actor],
    /// The time of each sample, as a fraction of the duration.
    pub(super) parts: Vec<f64>,
    /// \[s\]
    pub(super) duration: f64,
    pub(super) view: View,
}

/// The place of a stage on the page.
struct Placed {
    /// Pixels per meter.
    scale: f64,
    /// The place of the origin, in pixels.
    origin: [f64; 2],
}

impl Stage<'_> {
    /// Style rules for the motion, and the elements.
    pub(super) fn drawn(&self) -> [String; 2] {
        let placed = self.placed();
        let [mut rules, mut bodies] = [String::new(), String::new()];
        for (number, actor) in self.actors.iter().enumerate() {
            let elements = faces::elements(&actor.solid.faces, number % COLORS.len(), placed.scale);
            let motion = self.frames(actor, placed.scale);
            let Some((first, frames)) = motion else {
                continue;
            };
            if frames.is_empty() {
                let _ = write!(
                    bodies,
                    "<div class=\"body\" style=\"{first}\">{elements}</div>"
                );
                continue;
            }
            let duration = self.period();
            let _ = write!(rules, "@keyframes b{number}{{{frames}}}");
            let _ = write!(
                bodies,
                "<div class=\"body\" style=\"animation:b{number} {duration}s linear infinite\">\
                 {elements}</div>"
            );
        }
        let [x, y] = placed.origin.map(|place| short(place, 1));
        let scene = std::format!(
            "<div class=\"stage\">{}<div class=\"scene\" style=\"transform:translate({x}px,{y}px) \
             {}\">{bodies}</div></div>",
            self.backdrop(&placed),
            self.view.matrix(),
        );
        [rules, scene]
    }

    /// All finite places, in pixels per meter, centered.
    fn placed(&self) -> Placed {
        let mut low = [f64::INFINITY; 2];
        let mut high = [f64::NEG_INFINITY; 2];
        for actor in self.actors {
            let radius = actor.solid.radius();
            for pose in actor.poses.iter().filter(|pose| pose.is_finite()) {
                let seen = self.view.seen(&pose.position);
                for axis in 0..2 {
                    low[axis] = low[axis].min(seen[axis] - radius);
                    high[axis] = high[axis].max(seen[axis] + radius);
                }
            }
        }
        let size = [0, 1].map(|axis| high[axis] - low[axis]);
        let room = [WIDTH, HEIGHT].map(|length| length - 2.0 * MARGIN);
        let scale = (room[0] / size[0]).min(room[1] / size[1]);
        if !(scale.is_finite() && scale > 0.0) {
            return Placed {
                scale: 100.0,
                origin: [0.5 * WIDTH, 0.5 * HEIGHT],
            };
        }
        let middle = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]) * scale);
        Placed {
            scale,
            origin: [0.5 * WIDTH - middle[0], 0.5 * HEIGHT + middle[1]],
        }
    }

    /// The duration in seconds, as text.
    pub(super) fn period(&self) -> String {
        short(self.duration, if self.duration < 1.0 { 9 } else { 3 })
    }

    /// The style at the first finite sample, and the frames, if anything is finite.
    fn frames(&self, actor: &Actor, scale: f64) -> Option<(String, String)> {
        let stride = actor.poses.len().div_ceil(FRAMES).max(1);
        let last = actor.poses.len().checked_sub(1)?;
        let moves = self.duration > 0.0 && self.duration.is_finite() && last > 0;
        let shown = if actor.poses.iter().all(Pose::is_finite) {
            ""
        } else {
            ";visibility:visible"
        };
        let mut turn: Option<UnitQuaternion<f64>> = None;
        let mut before: Option<(f64, bool)> = None;
        let [mut first, mut frames] = [String::new(), String::new()];
        for (place, (part, pose)) in self.parts.iter().zip(&actor.poses).enumerate() {
            let is_skipped = place % stride != 0 && place != last;
            if is_skipped || moves && !part.is_finite() {
                continue;
            }
            let (percent, is_there) = (100.0 * part, pose.is_finite());
            let mut hide = |percent: f64| {
                let _ = write!(frames, "{}%{{visibility:hidden}}", short(percent, 4));
            };
            // a partly visible solid counts as visible: it is hidden right next to its gaps
            match before.replace((percent, is_there)) {
                Some((before, true)) if !is_there => hide(before + BESIDE),
                Some((_, false)) if is_there => hide(percent - BESIDE),
                _ => {}
            }
            if !is_there {
                hide(percent);
                continue;
            }
            let attitude = next_to(turn.as_ref(), &pose.attitude);
            turn = Some(attitude);
            let transform = transform(&pose.position, &attitude, scale);
            if first.is_empty() {
                first = std::format!("transform:{transform}");
            }
            let percent = short(percent, 3);
            let _ = write!(frames, "{percent}%{{transform:{transform}{shown}}}");
        }
        if first.is_empty() {
            return None;
        }
        Some((first, if moves { frames } else { String::new() }))
    }

    /// What is drawn behind the solids: the paths of their origins, the world axes and a scale bar.
    fn backdrop(&self, placed: &Placed) -> String {
        let mut out = std::format!(
            "<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\">"
        );
        for (number, actor) in self.actors.iter().enumerate() {
            let places = actor.poses.iter().map(|pose| {
                let seen = self.view.seen(&pose.position) * placed.scale;
                [placed.origin[0] + seen.x, placed.origin[1] - seen.y]
            });
            let places = path(places);
            let color = number % COLORS.len();
            let _ = write!(out, "<path class=\"curve trail c{color}\" d=\"{places}\"/>");
        }
        let corner = [44.0, HEIGHT - 44.0];
        for (axis, name) in [
            (Vector3::x(), 'x'),
            (Vector3::y(), 'y'),
            (Vector3::z(), 'z'),
        ] {
            let seen = self.view.seen(&axis) * 28.0;
            if seen.xy().norm() < 1.0 {
                continue;
            }
            let tip = [corner[0] + seen.x, corner[1] - seen.y].map(|place| short(place, 1));
            let name_at = [corner[0] + 1.3 * seen.x, corner[1] + 4.0 - 1.3 * seen.y];
            let [x, y] = name_at.map(|place| short(place, 1));
            let _ = write!(
                out,
                "<path class=\"frame\" d=\"M{} {}L{} {}\"/>\
                 <text class=\"faint\" x=\"{x}\" y=\"{y}\" text-anchor=\"middle\">{name}</text>",
                corner[0], corner[1], tip[0], tip[1],
            );
        }
        out.push_str(&measure(placed.scale));
        out.push_str("</svg>");
        out
    }
}

/// A round length in the corner, with its text.
fn measure(scale: f64) -> String {
    let longest = 120.0 / scale;
    let decade = 10_f64.powf(longest.log10().floor());
    let lengths = [5.0, 2.0, 1.0].map(|factor| factor * decade);
    let length = lengths.into_iter().find(|length| *length <= longest);
    let length = length.unwrap_or(decade);
    let text = if (1e-3..1e4).contains(&length) {
        short(length, 3)
    } else {
        std::format!("{length:.0e}")
    };
    let (right, y) = (WIDTH - MARGIN, HEIGHT - 20.0);
    let left = right - length * scale;
    std::format!(
        "<path class=\"frame\" d=\"M{} {}v6H{right}v-6\"/>\
         <text class=\"faint\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{text} m</text>",
        short(left, 1),
        y - 6.0,
        short(0.5 * (left + right), 1),
        y - 6.0,
    )
}

/// The sign of an attitude quaternion that is nearer to another one, so that the rotation between
/// them is the short one.
fn next_to(
    other: Option<&UnitQuaternion<f64>>,
    attitude: &UnitQuaternion<f64>,
) -> UnitQuaternion<f64> {
    if other.is_some_and(|other| other.coords.dot(&attitude.coords) < 0.0) {
        UnitQuaternion::new_unchecked(-attitude.into_inner())
    } else {
        *attitude
    }
}

/// The transform of style sheets.
fn transform(position: &Vector3<f64>, attitude: &UnitQuaternion<f64>, scale: f64) -> String {
    let [x, y, z] = [0, 1, 2].map(|axis| short(position[axis] * scale, 1));
    let imaginary = attitude.imag();
    let angle = 2.0 * imaginary.norm().atan2(attitude.w);
    let axis = imaginary.try_normalize(1e-9).unwrap_or_else(Vector3::z);
    let [a, b, c] = [0, 1, 2].map(|place| short(axis[place], 4));
    let angle = short(angle, 4);
    std::format!("translate3d({x}px,{y}px,{z}px) rotate3d({a},{b},{c},{angle}rad)")
}
