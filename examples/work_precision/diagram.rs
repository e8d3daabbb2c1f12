//! Error against time, both in logarithms: a panel for each problem, a line for each method.

use crate::drawing::{line, picture, text};
use crate::measure::{Curve, Point};
use crate::table::problems;

const COLUMNS: usize = 3;
/// A panel with its margins, and what it draws in.
const PANEL: [f64; 2] = [330.0, 270.0];
const PLOT: [f64; 2] = [260.0, 200.0];
/// From the corner of the panel to that of what it draws in.
const CORNER: [f64; 2] = [50.0, 30.0];
/// Decades of the error, from left to right.
const ERRORS: [i32; 2] = [0, -16];
/// A line of the legend.
const LINE: f64 = 20.0;

/// Of the methods, in the order in which they first come; more begin again.
const COLOURS: [&str; 16] = [
    "#d62728", "#1f77b4", "#17becf", "#9467bd", "#ff7f0e", "#7f7f7f", "#c7c7c7", "#bcbd22",
    "#8c564b", "#e7ba52", "#ff7f0e", "#843c39", "#000000", "#2ca02c", "#98df8a", "#e377c2",
];

/// All problems in one picture.
pub fn diagram(curves: &[Curve]) -> String {
    let methods = methods(curves);
    let problems = problems(curves);
    let rows = problems.len().div_ceil(COLUMNS);
    let mut drawn = String::new();
    for (place, problem) in problems.into_iter().enumerate() {
        let corner = [
            exact(place % COLUMNS) * PANEL[0] + CORNER[0],
            exact(place / COLUMNS) * PANEL[1] + CORNER[1],
        ];
        let of_problem: Vec<&Curve> = curves
            .iter()
            .filter(|curve| curve.problem == problem)
            .collect();
        drawn += &panel(problem, &of_problem, &methods, corner);
    }
    let top = exact(rows) * PANEL[1] + LINE;
    drawn += &text(
        CORNER[0],
        top,
        "start",
        "across: error at the end; upwards: ns for a simulated second of one body",
    );
    for (place, method) in methods.iter().enumerate() {
        let x = exact(place % COLUMNS) * PANEL[0] + CORNER[0];
        let y = top + exact(place / COLUMNS + 1) * LINE;
        drawn += &line([x, y - 4.0], [x + 24.0, y - 4.0], colour(place), 2.0);
        drawn += &text(x + 30.0, y, "start", method);
    }
    let height = top + (exact(methods.len().div_ceil(COLUMNS)) + 1.0) * LINE;
    picture(exact(COLUMNS) * PANEL[0], height, &drawn)
}

fn panel(problem: &str, curves: &[&Curve], methods: &[&str], [left, top]: [f64; 2]) -> String {
    let times = || {
        curves
            .iter()
            .flat_map(|curve| &curve.points)
            .map(|p| p.time.log10())
    };
    let low = times().fold(f64::INFINITY, f64::min).floor();
    let high = times().fold(f64::NEG_INFINITY, f64::max).ceil();
    let [from, to] = ERRORS.map(f64::from);
    let x = |decade: f64| left + (decade - from) / (to - from) * PLOT[0];
    let y = |decade: f64| top + (high - decade) / (high - low) * PLOT[1];

    let mut drawn = text(left + PLOT[0] / 2.0, top - 8.0, "middle", problem);
    for decade in (ERRORS[1]..=ERRORS[0]).step_by(4) {
        let at = x(f64::from(decade));
        drawn += &line([at, top], [at, top + PLOT[1]], "#dddddd", 1.0);
        drawn += &text(at, top + PLOT[1] + 16.0, "middle", power(f64::from(decade)));
    }
    let mut decade = low;
    while decade <= high {
        drawn += &line(
            [left, y(decade)],
            [left + PLOT[0], y(decade)],
            "#dddddd",
            1.0,
        );
        drawn += &text(left - 6.0, y(decade) + 4.0, "end", power(decade));
        decade += 1.0;
    }
    for curve in curves {
        let place = methods.iter().position(|method| *method == curve.method);
        let colour = colour(place.expect("a method of the curves"));
        let places: Vec<[f64; 2]> = curve
            .best()
            .iter()
            .map(|Point { time, error, .. }| {
                // an error of nothing is drawn at the edge
                [x(error.log10().clamp(to, from)), y(time.log10())]
            })
            .collect();
        drawn += &path(&places, colour);
    }
    drawn
}

/// A line through places, with a mark on each.
fn path(places: &[[f64; 2]], colour: &str) -> String {
    let joined = |each: fn(&[f64; 2]) -> String| places.iter().map(each).collect::<Vec<_>>();
    let points = joined(|[x, y]| format!("{x:.1},{y:.1}")).join(" ");
    // a line of no length has a round end, as a mark
    let marks = joined(|[x, y]| format!("M{x:.1} {y:.1}h0")).concat();
    format!(
        "<g fill=\"none\" stroke=\"{colour}\" stroke-linecap=\"round\">\
         <polyline points=\"{points}\" stroke-width=\"1.5\"/><path d=\"{marks}\" stroke-width=\"4\"/></g>\n"
    )
}

/// The methods, in the order in which they first come.
fn methods(curves: &[Curve]) -> Vec<&str> {
    let mut methods: Vec<&str> = Vec::new();
    for curve in curves {
        if !methods.contains(&curve.method.as_str()) {
            methods.push(&curve.method);
        }
    }
    methods
}

fn colour(place: usize) -> &'static str {
    COLOURS[place % COLOURS.len()]
}

/// A power of ten.
fn power(decade: f64) -> String {
    let raised = |digit: char| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        // 0 and 4 to 9 follow one another
        _ => char::from_u32('⁰' as u32 + u32::from(digit) - u32::from('0')).unwrap_or(digit),
    };
    let exponent: String = format!("{decade:.0}").chars().map(raised).collect();
    format!("10{exponent}")
}

#[expect(clippy::cast_precision_loss, reason = "small counts")]
fn exact(count: usize) -> f64 {
    count as f64
}
