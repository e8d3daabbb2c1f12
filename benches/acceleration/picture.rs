//! The table as a picture: a bar for each ratio, a mark where it is to be.

use std::fmt::Write;

use crate::table::{Row, Table};

const LINE: f64 = 20.0;
/// Width of the names, and of the names with the numbers.
const NAMES: f64 = 370.0;
const LEFT: f64 = 420.0;
/// Width of a ratio of one.
const ONE: f64 = 300.0;
const MARGIN: f64 = 20.0;

/// Bars in SVG.
pub fn bars(table: &Table) -> String {
    let mut bottom = 2.5 * LINE;
    let mut bars = String::new();
    for row in &table.rows {
        bars += &bar(row, bottom);
        bottom += LINE;
    }
    let ratios = table.rows.iter().map(|row| row.times.ratio[1]);
    let (one, width) = (LEFT + ONE, LEFT + ratios.fold(1.0, f64::max) * ONE + MARGIN);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n\
         <text x=\"{LEFT}\" y=\"{LINE}\">time of generated code over hand-written; red: what is asked for</text>\n\
         <line x1=\"{one}\" y1=\"{}\" x2=\"{one}\" y2=\"{bottom}\" stroke=\"gray\"/>\n\
         {bars}</svg>\n",
        bottom + LINE / 2.0,
        1.5 * LINE,
    )
}

fn bar(row: &Row, top: f64) -> String {
    let [_, ratio, _] = row.times.ratio;
    let (length, middle, height) = (ratio * ONE, top + 0.7 * LINE, 0.8 * LINE);
    let mut bar = format!(
        "<text x=\"{NAMES}\" y=\"{middle}\" text-anchor=\"end\">{}</text>\n\
         <text x=\"{}\" y=\"{middle}\" text-anchor=\"end\">{ratio:.2}</text>\n\
         <rect x=\"{LEFT}\" y=\"{top}\" width=\"{length:.1}\" height=\"{height}\" fill=\"steelblue\"/>\n",
        row.what,
        LEFT - 8.0,
    );
    if let Some(reach) = row.reach {
        let x = LEFT + reach * ONE;
        writeln!(
            bar,
            "<line x1=\"{x:.1}\" y1=\"{}\" x2=\"{x:.1}\" y2=\"{}\" stroke=\"red\" stroke-width=\"2\"/>",
            top - 1.0,
            top + height + 1.0,
        )
        .expect("a string takes all");
    }
    bar
}
