//! Error against time, both in logarithms: a panel for each problem, a line for each method.

use crate::chart::{Across, Line, Panel, chart};
use crate::measure::{Curve, Point};
use crate::table::problems;

/// Of the error.
const ERRORS: Across = Across {
    decades: [0, -16],
    step: 4,
};

/// All problems in one picture.
pub fn diagram(curves: &[Curve]) -> String {
    let panel = |problem| {
        let of_problem = curves.iter().filter(|curve| curve.problem == problem);
        Panel {
            title: problem,
            lines: of_problem.map(drawn).collect(),
        }
    };
    let panels: Vec<Panel<'_>> = problems(curves).into_iter().map(panel).collect();
    let caption = "across: error at the end; upwards: ns for a simulated second of one body";
    chart(&panels, ERRORS, caption)
}

fn drawn(curve: &Curve) -> Line<'_> {
    let place = |&Point { time, error, .. }: &Point| [error.log10(), time.log10()];
    Line {
        name: &curve.method,
        points: curve.best().iter().map(place).collect(),
    }
}
