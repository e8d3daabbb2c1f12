//! Pictures in SVG.

use std::fmt::Display;

/// A picture on a white background.
pub fn picture(width: f64, height: f64, drawn: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n\
         {drawn}</svg>\n"
    )
}

/// Text whose start, middle or end is at a place: `start`, `middle`, `end`.
pub fn text(x: f64, y: f64, anchor: &str, words: impl Display) -> String {
    format!("<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{words}</text>\n")
}

/// A straight line between two places.
pub fn line([x, y]: [f64; 2], [to_x, to_y]: [f64; 2], stroke: &str, width: f64) -> String {
    format!(
        "<line x1=\"{x:.1}\" y1=\"{y:.1}\" x2=\"{to_x:.1}\" y2=\"{to_y:.1}\" stroke=\"{stroke}\" stroke-width=\"{width}\"/>\n"
    )
}
