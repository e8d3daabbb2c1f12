//! Curves over logarithmic axes: a panel for each group, a color for each name, and a legend.

use crate::drawing::{line, picture, text};

const COLUMNS: usize = 3;
/// The size of a panel with its margins, and of its plot area.
const PANEL: [f64; 2] = [330.0, 270.0];
const PLOT: [f64; 2] = [260.0, 200.0];
/// The offset from the corner of a panel to that of its plot area.
const CORNER: [f64; 2] = [50.0, 30.0];
/// The height of a line of the legend.
const LINE: f64 = 20.0;
/// If the vertical axis has more decades than this, only every fourth has a line.
const TALL: f64 = 8.0;

/// The colors of the names, in the order in which these first occur. If there are more names, the
/// colors repeat.
const COLORS: [&str; 16] = [
    "#d62728", "#1f77b4", "#17becf", "#9467bd", "#ff7f0e", "#7f7f7f", "#c7c7c7", "#bcbd22",
    "#8c564b", "#e7ba52", "#ff7f0e", "#843c39", "#000000", "#2ca02c", "#98df8a", "#e377c2",
];

/// A curve: its name, and its points as logarithms to base ten.
pub struct Line<'c> {
    pub name: &'c str,
    pub points: Vec<[f64; 2]>,
}

/// Curves over the same axes.
pub struct Panel<'c> {
    pub title: &'c str,
    pub lines: Vec<Line<'c>>,
}

/// The decades of the horizontal axis, and how many there are per line. Points beyond the ends are
/// drawn at the edge.
#[derive(Clone, Copy)]
pub struct Across {
    pub decades: [i32; 2],
    pub step: usize,
}

/// All panels in one picture.
pub fn chart(panels: &[Panel<'_>], across: Across, caption: &str) -> String {
    let names = names(panels);
    let rows = panels.len().div_ceil(COLUMNS);
    let mut drawn = String::new();
    for (place, of_panel) in panels.iter().enumerate() {
        let corner = [
            exact(place % COLUMNS) * PANEL[0] + CORNER[0],
            exact(place / COLUMNS) * PANEL[1] + CORNER[1],
        ];
        drawn += &panel(of_panel, across, &names, corner);
    }
    let top = exact(rows) * PANEL[1] + LINE;
    drawn += &text(CORNER[0], top, "start", caption);
    for (place, name) in names.iter().enumerate() {
        let x = exact(place % COLUMNS) * PANEL[0] + CORNER[0];
        let y = top + exact(place / COLUMNS + 1) * LINE;
        drawn += &line([x, y - 4.0], [x + 24.0, y - 4.0], color(place), 2.0);
        drawn += &text(x + 30.0, y, "start", name);
    }
    let height = top + (exact(names.len().div_ceil(COLUMNS)) + 1.0) * LINE;
    picture(exact(COLUMNS) * PANEL[0], height, &drawn)
}

fn panel(panel: &Panel<'_>, across: Across, names: &[&str], [left, top]: [f64; 2]) -> String {
    let heights = || {
        panel
            .lines
            .iter()
            .flat_map(|line| &line.points)
            .map(|p| p[1])
    };
    let low = heights().fold(f64::INFINITY, f64::min).floor();
    let high = heights().fold(f64::NEG_INFINITY, f64::max).ceil();
    let [from, to] = across.decades.map(f64::from);
    let x = |decade: f64| left + (decade - from) / (to - from) * PLOT[0];
    let y = |decade: f64| top + (high - decade) / (high - low) * PLOT[1];

    let mut drawn = text(left + PLOT[0] / 2.0, top - 8.0, "middle", panel.title);
    let [first, last] = [from.min(to), from.max(to)];
    for decade in decades(first, last, exact(across.step)) {
        let at = x(decade);
        drawn += &line([at, top], [at, top + PLOT[1]], "#dddddd", 1.0);
        drawn += &text(at, top + PLOT[1] + 16.0, "middle", power(decade));
    }
    for decade in decades(low, high, if high - low > TALL { 4.0 } else { 1.0 }) {
        let at = y(decade);
        drawn += &line([left, at], [left + PLOT[0], at], "#dddddd", 1.0);
        drawn += &text(left - 6.0, at + 4.0, "end", power(decade));
    }
    for line in &panel.lines {
        let place = names.iter().position(|name| *name == line.name);
        let color = color(place.expect("a name of the lines"));
        let place = |[along, up]: &[f64; 2]| [x(along.clamp(first, last)), y(*up)];
        let places: Vec<[f64; 2]> = line.points.iter().map(place).collect();
        drawn += &path(&places, color);
    }
    drawn
}

fn decades(first: f64, last: f64, step: f64) -> impl Iterator<Item = f64> {
    let next = move |decade: &f64| Some(decade + step);
    std::iter::successors(Some(first), next).take_while(move |decade| *decade <= last)
}

/// A line through places, with a mark on each.
fn path(places: &[[f64; 2]], color: &str) -> String {
    let joined = |each: fn(&[f64; 2]) -> String| places.iter().map(each).collect::<Vec<_>>();
    let points = joined(|[x, y]| format!("{x:.1},{y:.1}")).join(" ");
    // a line of zero length with round ends is drawn as a dot
    let marks = joined(|[x, y]| format!("M{x:.1} {y:.1}h0")).concat();
    format!(
        "<g fill=\"none\" stroke=\"{color}\" stroke-linecap=\"round\">\
         <polyline points=\"{points}\" stroke-width=\"1.5\"/><path d=\"{marks}\" stroke-width=\"4\"/></g>\n"
    )
}

/// The names, in the order in which they first occur.
fn names<'c>(panels: &[Panel<'c>]) -> Vec<&'c str> {
    let mut names: Vec<&str> = Vec::new();
    for line in panels.iter().flat_map(|panel| &panel.lines) {
        if !names.contains(&line.name) {
            names.push(line.name);
        }
    }
    names
}

fn color(place: usize) -> &'static str {
    COLORS[place % COLORS.len()]
}

/// A power of ten.
fn power(decade: f64) -> String {
    let raised = |digit: char| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        // the characters for 0 and for 4 to 9 are consecutive
        _ => char::from_u32('⁰' as u32 + u32::from(digit) - u32::from('0')).unwrap_or(digit),
    };
    let exponent: String = format!("{decade:.0}").chars().map(raised).collect();
    format!("10{exponent}")
}

#[expect(clippy::cast_precision_loss, reason = "small counts")]
fn exact(count: usize) -> f64 {
    count as f64
}
