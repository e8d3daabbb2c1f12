//! The table as a picture: a bar for each ratio, and a mark at the ratio to be reached.

use std::fmt::Write;

use crate::drawing::{line, picture, text};
use crate::table::{Row, Table};

const LINE: f64 = 20.0;
/// The width of the names, and of the names with the numbers.
const NAMES: f64 = 370.0;
const LEFT: f64 = 420.0;
/// The width of a ratio of one.
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
    let title = "time of generated code over hand-written; red: what is asked for";
    let drawn = [
        text(LEFT, LINE, "start", title),
        line([one, 1.5 * LINE], [one, bottom], "gray", 1.0),
        bars,
    ];
    picture(width, bottom + LINE / 2.0, &drawn.concat())
}

fn bar(row: &Row, top: f64) -> String {
    let [_, ratio, _] = row.times.ratio;
    let (length, middle, height) = (ratio * ONE, top + 0.7 * LINE, 0.8 * LINE);
    let mut bar = text(NAMES, middle, "end", &row.what);
    bar += &text(LEFT - 8.0, middle, "end", format_args!("{ratio:.2}"));
    writeln!(
        bar,
        "<rect x=\"{LEFT}\" y=\"{top}\" width=\"{length:.1}\" height=\"{height}\" fill=\"steelblue\"/>"
    )
    .expect("a string takes all");
    if let Some(reach) = row.reach {
        let x = LEFT + reach * ONE;
        bar += &line([x, top - 1.0], [x, top + height + 1.0], "red", 2.0);
    }
    bar
}
