//! Pages of a motion.

use std::fmt::{self, Write as _};
use std::io;
use std::path::Path;
use std::string::{String, ToString as _};
use std::vec::Vec;

use nalgebra::Vector3;

use super::curve::UnknownColumn;
use super::markup::{Escaped, short, style};
use super::plot::Plot;
use super::pose::{Pose, Posed};
use super::solid::Solid;
use super::stage::{Actor, Stage};
use super::view::View;
use crate::bodies::columns::{Columns, Named};
use crate::integrate::Sample;

/// The rules of style of a page.
const RULES: &str = "body{background:var(--ground);color:var(--ink);font:14px system-ui,sans-serif;\
margin:24px auto;width:720px}h1{font-size:20px}.stage{position:relative;width:720px;height:420px;\
overflow:hidden}.stage svg{position:absolute}.scene,.body,.body i{position:absolute;left:0;top:0;\
transform-origin:0 0;transform-style:preserve-3d}.body i{backface-visibility:hidden}.trail{opacity:.45;stroke-width:1.2}\
.cursor{stroke:var(--ink);opacity:.6}label{user-select:none}\
#pause:checked~*,#pause:checked~* *{animation-play-state:paused!important}\
@media(prefers-reduced-motion:reduce){*{animation-play-state:paused!important}}";

/// A page that shows a motion: moving solids, and plots with a cursor. It is a single HTML file
/// without scripts, and plays in any browser.
///
/// ```
/// use newton_euler::integrate::Sample;
/// use newton_euler::pictures::{Page, Pose, Solid};
/// use newton_euler::prelude::*;
///
/// let swing = |time: f64| Hinge { angle: time.sin(), angular_velocity: time.cos() };
/// let samples: Vec<_> =
///     (0..60).map(|k| 0.1 * f64::from(k)).map(|time| Sample { time, state: swing(time) }).collect();
///
/// let page = Page::of(&samples)
///     .title("A pendulum")
///     .solid_at(Solid::bar([0.0; 3], [0.0, -0.5, 0.0], 0.03), |_, state| {
///         Pose::planar([0.0, 0.0], state.angle)
///     })
///     .from_front()
///     .curves(&["angle"])?;
/// assert!(page.to_string().contains("@keyframes"));
/// # Ok::<(), newton_euler::pictures::UnknownColumn>(())
/// ```
#[derive(Clone, Debug)]
pub struct Page<'s, S> {
    samples: &'s [Sample<S>],
    title: String,
    actors: Vec<Actor>,
    plots: Vec<Plot<'s, S>>,
    view: View,
    speed: f64,
}

impl<'s, S> Page<'s, S> {
    /// An empty page for some samples. It repeats the motion in real time.
    #[must_use]
    pub fn of(samples: &'s [Sample<S>]) -> Self {
        Self {
            samples,
            title: String::new(),
            actors: Vec::new(),
            plots: Vec::new(),
            view: View::from(-0.6, 0.35),
            speed: 1.0,
        }
    }

    /// Sets the title.
    #[must_use]
    pub fn title(mut self, title: &str) -> Self {
        self.title = title.to_string();
        self
    }

    /// Adds a solid of the body. A motion in a plane is seen from the front.
    #[must_use]
    pub fn solid(self, solid: Solid) -> Self
    where
        S: Posed,
    {
        let page = self.solid_at(solid, |_, state| state.pose());
        if S::IS_PLANAR {
            page.from_front()
        } else {
            page
        }
    }

    /// Adds a solid whose pose is a function of time and state, such as a body of a system. Faces
    /// with corners that are not finite are left out.
    #[must_use]
    pub fn solid_at(mut self, mut solid: Solid, pose: impl Fn(f64, &S) -> Pose) -> Self {
        let is_finite = |corner: &Vector3<f64>| corner.iter().all(|part| part.is_finite());
        solid.faces.retain(|face| face.iter().all(is_finite));
        let poses = self.samples.iter();
        let poses = poses.map(|sample| pose(sample.time, &sample.state));
        self.actors.push(Actor {
            solid,
            poses: poses.collect(),
        });
        self
    }

    /// Adds the plot of the columns with these names: see [`Plot::of`].
    ///
    /// # Errors
    /// [`UnknownColumn`], for a name that is not a column of the state.
    pub fn curves(self, names: &[&str]) -> Result<Self, UnknownColumn>
    where
        S: Columns<f64> + Named,
    {
        let plot = Plot::of(self.samples, names)?;
        Ok(self.plot(plot))
    }

    /// Adds a plot. If its horizontal axis is time, a cursor moves along.
    #[must_use]
    pub fn plot(mut self, plot: Plot<'s, S>) -> Self {
        self.plots.push(plot);
        self
    }

    /// Shows the solids from the front: x to the right, y up.
    #[must_use]
    pub fn from_front(mut self) -> Self {
        self.view = View::of_plane();
        self
    }

    /// Shows the solids with z up, seen from an azimuth, counterclockwise from the x-axis, and an
    /// elevation above the horizon \[rad\]. Angles that are not finite change nothing.
    #[must_use]
    pub fn seen_from(mut self, azimuth: f64, elevation: f64) -> Self {
        if azimuth.is_finite() && elevation.is_finite() {
            self.view = View::from(azimuth, elevation);
        }
        self
    }

    /// Sets how many seconds of the motion pass in a second. A number that is not positive and
    /// finite changes nothing.
    #[must_use]
    pub fn speed(mut self, speed: f64) -> Self {
        if speed.is_finite() && speed > 0.0 {
            self.speed = speed;
        }
        self
    }

    /// Writes it to a file.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, path: impl AsRef<Path>) -> io::Result<()> {
        std::fs::write(path, self.to_string())
    }

    fn stage(&self) -> Stage<'_> {
        let [start, end] = match self.samples {
            [first, .., last] => [first.time, last.time],
            _ => [0.0, 0.0],
        };
        let times = self.samples.iter().map(|sample| sample.time);
        let parts = times.map(|time| ((time - start) / (end - start)).clamp(0.0, 1.0));
        Stage {
            actors: &self.actors,
            parts: parts.collect(),
            duration: ((end - start) / self.speed).abs(),
            view: self.view,
        }
    }
}

impl<S> fmt::Display for Page<'_, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let stage = self.stage();
        let mut body = String::new();
        let mut rules = String::new();
        if !self.actors.is_empty() {
            let [frames, scene] = stage.drawn();
            rules.push_str(&frames);
            body.push_str(&scene);
        }
        let moves = stage.duration > 0.0 && stage.duration.is_finite();
        for (number, plot) in self.plots.iter().enumerate() {
            let drawn = plot.drawn();
            let [left, right] = drawn.across;
            let mut cursor = String::new();
            if moves && plot.is_against_time() {
                let _ = write!(
                    rules,
                    "@keyframes k{number}{{to{{transform:translateX({}px)}}}}",
                    short(right - left, 1)
                );
                let (bottom, duration) = (drawn.height, stage.period());
                let _ = write!(
                    cursor,
                    "<path class=\"cursor\" d=\"M{left} 8V{}\" \
                     style=\"animation:k{number} {duration}s linear infinite\"/>",
                    bottom - 42.0
                );
            }
            body.push_str(&drawn.framed("", &cursor));
        }
        let title = Escaped(&self.title);
        writeln!(
            f,
            "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"/>\
             <meta name=\"color-scheme\" content=\"light dark\"/><title>{title}</title>\
             <style>{}{RULES}{rules}</style></head><body><h1>{title}</h1>\
             <input type=\"checkbox\" id=\"pause\"/><label for=\"pause\"> pause</label>{body}\
             </body></html>",
            style()
        )
    }
}
