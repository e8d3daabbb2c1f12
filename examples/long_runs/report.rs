//! The results in numbers and in a picture.

use std::fmt::{self, Write as _};

use crate::chart::{Across, Line, Panel, chart};
use crate::growth::{Growth, Row};
use crate::problem::QUANTITIES;

/// A line for each number of steps of each method, under a line of names; empty where nothing is known.
pub fn csv(all: &[Growth]) -> String {
    let mut text = format!("problem,method,step,steps,{}\n", QUANTITIES.join(","));
    for growth in all {
        for Row { steps, errors } in &growth.rows {
            let Growth {
                problem,
                method,
                step,
                ..
            } = growth;
            let errors =
                errors.map(|error| error.map_or(String::new(), |error| format!("{error:.3e}")));
            let errors = errors.join(",");
            writeln!(text, "\"{problem}\",\"{method}\",{step},{steps},{errors}")
                .expect("a string takes all");
        }
    }
    text
}

/// A panel for each quantity of each problem.
pub fn picture(all: &[Growth]) -> String {
    let titles: Vec<(&str, usize, String)> = problems(all)
        .into_iter()
        .flat_map(|problem| (0..QUANTITIES.len()).map(move |quantity| (problem, quantity)))
        .map(|(problem, quantity)| {
            (
                problem,
                quantity,
                format!("{problem}: {}", QUANTITIES[quantity]),
            )
        })
        .collect();
    let panels = titles.iter().map(|(problem, quantity, title)| {
        let of_problem = all.iter().filter(|growth| growth.problem == *problem);
        Panel {
            title,
            lines: of_problem.map(|growth| line(growth, *quantity)).collect(),
        }
    });
    // of what is not known there is nothing to see
    let panels: Vec<Panel<'_>> = panels
        .filter(|panel| panel.lines.iter().any(|line| !line.points.is_empty()))
        .collect();
    let across = Across {
        decades: [0, 8],
        step: 2,
    };
    let caption = "across: steps; upwards: relative error of energy and angular momentum, angle of the attitude in rad";
    chart(&panels, across, caption)
}

fn line(growth: &Growth, quantity: usize) -> Line<'_> {
    #[expect(clippy::cast_precision_loss, reason = "below 2⁵³")]
    let place = |row: &Row| Some([(row.steps as f64).log10(), row.errors[quantity]?.log10()]);
    let points = growth.rows.iter().filter_map(place);
    Line {
        name: growth.method,
        // an error of nothing has no logarithm
        points: points.filter(|[_, up]| up.is_finite()).collect(),
    }
}

/// The problems, in the order in which they first come.
fn problems(all: &[Growth]) -> Vec<&'static str> {
    let mut problems: Vec<&str> = all.iter().map(|growth| growth.problem).collect();
    problems.dedup();
    problems
}

/// The last errors of a problem, and the laws.
pub struct Table<'g>(pub &'g [Growth]);

impl fmt::Display for Table<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let problem = self.0.first().map_or("", |growth| growth.problem);
        write!(
            f,
            "{problem:<16}{:>9}{:>9}{:>12}",
            "step/s", "ns/step", "steps"
        )?;
        for quantity in QUANTITIES {
            write!(f, "{quantity:>24}")?;
        }
        writeln!(f)?;
        self.0.iter().try_for_each(|growth| row(f, growth))
    }
}

fn row(f: &mut fmt::Formatter<'_>, growth: &Growth) -> fmt::Result {
    let Some(last) = growth.rows.last() else {
        return Ok(());
    };
    let Growth {
        method, step, cost, ..
    } = growth;
    write!(f, "  {method:<14}{step:>9}{cost:>9.0}{:>12}", last.steps)?;
    for (quantity, expected) in growth.expected.iter().enumerate() {
        let words = last.errors[quantity].map_or("-".into(), |error| {
            let exponent = growth.exponent(quantity);
            let exponent = exponent.map_or("-".into(), |exponent| format!("{exponent:.2}"));
            format!("{error:.1e}  {exponent:>5} ({expected})")
        });
        write!(f, "{words:>24}")?;
    }
    writeln!(f)
}
