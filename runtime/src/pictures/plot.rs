//! Plots of samples, as SVG.

use std::fmt::{self, Write as _};
use std::io;
use std::path::Path;
use std::string::{String, ToString as _};
use std::vec::Vec;

use super::axis::Axis;
use super::curve::{Curve, UnknownColumn, columns, short_names};
use super::markup::{COLORS, DASHES, Escaped, short, style};
use crate::bodies::columns::{Columns, Named};
use crate::integrate::Sample;

/// The size of a picture without the labels of curves, and the size of its margins, in pixels.
const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 190.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 42.0;
const TITLE: f64 = 26.0;
/// The width of a character, and the height of a line.
const SIGN: f64 = 6.8;
const LINE: f64 = 14.0;

/// A plot of samples, as SVG: one panel for each unit, one curve for each number.
///
/// The axes have units, and the curves have labels at their ends. Numbers that are infinite or NaN
/// leave gaps.
///
/// ```
/// use newton_euler::integrate::Sample;
/// use newton_euler::pictures::Plot;
/// use newton_euler::prelude::*;
///
/// let at = |time: f64| Hinge { angle: time.sin(), angular_velocity: time.cos() };
/// let samples: Vec<_> =
///     (0..100).map(|k| 0.1 * f64::from(k)).map(|time| Sample { time, state: at(time) }).collect();
///
/// let svg = Plot::of(&samples, &["angle", "angular_velocity"])?.title("A pendulum").to_string();
/// assert!(svg.starts_with("<svg") && svg.contains("angular_velocity [rad/s]"));
///
/// let unknown = Plot::of(&samples, &["speed"]).expect_err("there is none");
/// let message = "no column is called `speed`; there are angle, angular_velocity";
/// assert_eq!(unknown.to_string(), message);
/// # Ok::<(), newton_euler::pictures::UnknownColumn>(())
/// ```
#[derive(Clone, Debug)]
pub struct Plot<'s, S> {
    samples: &'s [Sample<S>],
    title: String,
    /// The curve of the abscissas.
    across: Curve,
    curves: Vec<Curve>,
    has_equal_scales: bool,
}

impl<'s, S: Columns<f64> + Named> Plot<'s, S> {
    /// The columns with these names against time. The name of a part, such as `velocity`, selects
    /// all of its columns.
    ///
    /// # Errors
    /// [`UnknownColumn`], for a name that is neither a column of the state nor a part with columns.
    pub fn of(samples: &'s [Sample<S>], names: &[&str]) -> Result<Self, UnknownColumn> {
        let curves = columns(samples, names)?;
        Ok(Self {
            curves,
            ..Self::empty(samples)
        })
    }
}

impl<'s, S> Plot<'s, S> {
    /// An empty plot, for states of any type.
    #[must_use]
    pub fn empty(samples: &'s [Sample<S>]) -> Self {
        Self {
            samples,
            title: String::new(),
            across: Curve::of(samples, "time", "s", |time, _| time),
            curves: Vec::new(),
            has_equal_scales: false,
        }
    }

    /// Adds a curve of a function of time and state, with its name and its unit.
    #[must_use]
    pub fn curve(mut self, name: &str, unit: &str, function: impl Fn(f64, &S) -> f64) -> Self {
        let curve = Curve::of(self.samples, name, unit, function);
        self.curves.push(curve);
        self
    }

    /// Draws the curves against a function of time and state, instead of time.
    #[must_use]
    pub fn against(mut self, name: &str, unit: &str, function: impl Fn(f64, &S) -> f64) -> Self {
        self.across = Curve::of(self.samples, name, unit, function);
        self
    }

    /// Draws both axes to the same scale, for paths in a plane.
    #[must_use]
    pub fn to_scale(mut self) -> Self {
        self.has_equal_scales = true;
        self
    }

    /// Sets the title.
    #[must_use]
    pub fn title(mut self, title: &str) -> Self {
        self.title = title.to_string();
        self
    }

    /// Writes it to a file.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, path: impl AsRef<Path>) -> io::Result<()> {
        std::fs::write(path, self.to_string())
    }

    /// Whether a cursor that moves with time is possible.
    pub(super) fn is_against_time(&self) -> bool {
        let times = self.samples.iter().map(|sample| sample.time.to_bits());
        times.eq(self.across.numbers.iter().map(|time| time.to_bits()))
    }

    /// The drawing.
    pub(super) fn drawn(&self) -> Drawn {
        let mut units: Vec<&str> = Vec::new();
        for curve in &self.curves {
            if !units.contains(&curve.unit.as_str()) {
                units.push(&curve.unit);
            }
        }
        let panels: Vec<_> = units.iter().map(|unit| self.panel(unit)).collect();
        let left = panels.iter().map(|panel| panel.left).fold(0.0, f64::max);
        let right = panels.iter().map(|panel| panel.right).fold(0.0, f64::max);
        let mut drawn = Drawn {
            height: if self.title.is_empty() { 0.0 } else { TITLE },
            across: [left, WIDTH - right],
            markup: String::new(),
        };
        if !self.title.is_empty() {
            let title = Escaped(&self.title);
            let _ = write!(
                drawn.markup,
                "<text class=\"title\" x=\"{left}\" y=\"18\">{title}</text>"
            );
        }
        for panel in &panels {
            self.draw(panel, &mut drawn);
        }
        drawn
    }

    /// The curves with the same unit, and the space for their labels.
    fn panel(&self, unit: &str) -> Panel<'_> {
        let curves = self.curves.iter();
        let curves: Vec<_> = curves.filter(|curve| curve.unit == unit).collect();
        let (name, labels) = short_names(&curves);
        let numbers = curves
            .iter()
            .flat_map(|curve| curve.numbers.iter().copied());
        let up = Axis::covering(numbers, [HEIGHT, 0.0]).widened(0.06);
        let length = labels.iter().map(|label| label.chars().count()).max();
        Panel {
            left: 46.0 + SIGN * real(up.ticks(6).width()),
            right: 16.0 + SIGN * real(length.unwrap_or(0)),
            unit: unit.to_string(),
            name,
            labels,
            curves,
            up,
        }
    }

    /// The axes of a panel: the horizontal one over its place, the vertical one from zero to its
    /// height.
    fn axes(&self, panel: &Panel<'_>, across: [f64; 2]) -> (Axis, Axis, f64) {
        let x = Axis::covering(self.across.numbers.iter().copied(), across);
        if !self.has_equal_scales {
            return (x, panel.up, HEIGHT);
        }
        let x = x.widened(0.04);
        let numbers = panel
            .curves
            .iter()
            .flat_map(|curve| curve.numbers.iter().copied());
        let height = (across[1] - across[0]) * 0.8;
        let up = Axis::covering(numbers, [height, 0.0]).widened(0.04);
        let scale = x.scale().min(up.scale());
        (x.at_scale(scale), up.at_scale(scale), height)
    }

    fn draw(&self, panel: &Panel<'_>, drawn: &mut Drawn) {
        let [left, right] = drawn.across;
        let (x, y, height) = self.axes(panel, drawn.across);
        let top = drawn.height + TOP;
        let (out, bottom) = (&mut drawn.markup, top + height);
        let _ = write!(out, "<g transform=\"translate(0 {top})\">");
        let across = x.ticks(7);
        for (number, text) in &across.all {
            let place = short(x.place(*number), 1);
            let _ = write!(
                out,
                "<path class=\"grid\" d=\"M{place} 0V{height}\"/>\
                 <text class=\"faint\" x=\"{place}\" y=\"{}\" text-anchor=\"middle\">{text}</text>",
                height + 15.0
            );
        }
        let up = y.ticks(6);
        for (number, text) in &up.all {
            let place = y.place(*number);
            let _ = write!(
                out,
                "<path class=\"grid\" d=\"M{left} {}H{right}\"/>\
                 <text class=\"faint\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{text}</text>",
                short(place, 1),
                left - 6.0,
                short(place + 4.0, 1),
            );
        }
        let _ = write!(
            out,
            "<path class=\"frame\" d=\"M{left} 0V{height}H{right}\"/>\
             <text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\
             <text transform=\"translate(14 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            short(0.5 * (left + right), 1),
            height + 33.0,
            Escaped(&across.label(&self.across.name, &self.across.unit)),
            short(0.5 * height, 1),
            Escaped(&up.label(&panel.name, &panel.unit)),
        );
        let mut ends = Vec::new();
        for (order, curve) in panel.curves.iter().enumerate() {
            let points = self.across.numbers.iter().zip(&curve.numbers);
            let mut points = points.map(|(across, up)| [x.place(*across), y.place(*up)]);
            let path = path(points.clone());
            let (color, dash) = (order % COLORS.len(), order / COLORS.len() % DASHES.len());
            let dash = match DASHES[dash] {
                "" => String::new(),
                dash => std::format!(" stroke-dasharray=\"{dash}\""),
            };
            let _ = write!(out, "<path class=\"curve c{color}\"{dash} d=\"{path}\"/>");
            let is_finite = |point: &[f64; 2]| point.iter().all(|number| number.is_finite());
            if let Some(end) = points.rfind(is_finite) {
                ends.push((end, color, &panel.labels[order]));
            }
        }
        label(out, right, height, ends);
        out.push_str("</g>");
        drawn.height = bottom + BOTTOM;
    }
}

/// Labels at the ends of curves, on the right, moved apart where they would overlap.
fn label(out: &mut String, right: f64, height: f64, mut ends: Vec<([f64; 2], usize, &String)>) {
    ends.retain(|(_, _, label)| !label.is_empty());
    ends.sort_by(|(one, ..), (other, ..)| one[1].total_cmp(&other[1]));
    let mut lines: Vec<f64> = Vec::new();
    for ([_, y], ..) in &ends {
        let above = lines.last().map_or(f64::NEG_INFINITY, |line| line + LINE);
        lines.push(y.max(above));
    }
    // those that are pushed out below move up again
    let mut below = height.max(LINE * real(lines.len()));
    for line in lines.iter_mut().rev() {
        *line = line.min(below);
        below = *line - LINE;
    }
    for (([x, y], color, label), line) in ends.iter().zip(lines) {
        let _ = write!(
            out,
            "<path class=\"leader c{color}\" d=\"M{} {}L{} {}\"/>\
             <text class=\"c{color}\" x=\"{}\" y=\"{}\">{}</text>",
            short(*x, 1),
            short(*y, 1),
            right + 6.0,
            short(line, 1),
            right + 9.0,
            short(line + 4.0, 1),
            Escaped(label),
        );
    }
}

/// The path through some points. A point that is not finite leaves a gap; a point between gaps is a
/// dot. Points that cannot be distinguished are drawn once.
pub(super) fn path(points: impl Iterator<Item = [f64; 2]>) -> String {
    let mut path = String::new();
    let mut last: Option<[f64; 2]> = None;
    let mut is_single = false;
    for [x, y] in points {
        if !(x.is_finite() && y.is_finite()) {
            last = None;
            continue;
        }
        if last.is_some_and(|[a, b]| (x - a).abs() < 0.3 && (y - b).abs() < 0.3) {
            continue;
        }
        let sign = if last.is_some() { 'L' } else { 'M' };
        if sign == 'M' && is_single {
            path.push_str("h.1");
        }
        is_single = sign == 'M';
        let _ = write!(path, "{sign}{} {}", short(x, 1), short(y, 1));
        last = Some([x, y]);
    }
    if is_single {
        path.push_str("h.1");
    }
    path
}

#[expect(clippy::cast_precision_loss, reason = "lengths of labels")]
fn real(count: usize) -> f64 {
    count as f64
}

/// Curves of one unit.
struct Panel<'p> {
    unit: String,
    name: String,
    labels: Vec<String>,
    curves: Vec<&'p Curve>,
    up: Axis,
    left: f64,
    right: f64,
}

/// The drawing of a plot, without its frame.
pub(super) struct Drawn {
    pub(super) markup: String,
    pub(super) height: f64,
    /// Where the curves begin and end.
    pub(super) across: [f64; 2],
}

impl Drawn {
    /// The picture, with something before its end.
    pub(super) fn framed(&self, style: &str, more: &str) -> String {
        let (markup, height) = (&self.markup, self.height.max(LINE));
        std::format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" \
             width=\"{WIDTH}\">{style}{markup}{more}</svg>\n"
        )
    }
}

impl<S> fmt::Display for Plot<'_, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let style = std::format!("<style>{}</style>", style());
        f.write_str(&self.drawn().framed(&style, ""))
    }
}
