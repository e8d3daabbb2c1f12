//! The results in numbers: a table to read, and comma-separated values, written and read again.

use std::fmt::{self, Write as _};

use crate::measure::{Curve, Point};
use crate::peers::DOP853;

/// The errors that are asked for.
const ERRORS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

const HEAD: &str = "problem,method,effort,ns_per_second,error";

/// A line for each effort of each method, under a line of names.
pub fn csv(curves: &[Curve]) -> String {
    let mut text = format!("{HEAD}\n");
    for Curve {
        problem,
        method,
        points,
    } in curves
    {
        for Point {
            effort,
            time,
            error,
        } in points
        {
            writeln!(
                text,
                "\"{problem}\",\"{method}\",{effort:e},{time:.3},{error:.3e}"
            )
            .expect("a string takes all");
        }
    }
    text
}

/// Reads what [`csv`] writes, as other programs write it too.
///
/// # Errors
/// The line that is not understood.
pub fn read(text: &str) -> Result<Vec<Curve>, String> {
    let mut curves: Vec<Curve> = Vec::new();
    let mut lines = text.lines();
    if lines.next() != Some(HEAD) {
        return Err(format!("not under the names {HEAD}"));
    }
    for line in lines {
        let (problem, method, point) = point(line).ok_or(format!("not understood: {line}"))?;
        match curves.last_mut() {
            Some(curve) if curve.problem == problem && curve.method == method => {
                curve.points.push(point);
            }
            _ => curves.push(Curve {
                problem: problem.into(),
                method: method.into(),
                points: vec![point],
            }),
        }
    }
    Ok(curves)
}

/// `"problem","method",effort,time,error`: names may have commas.
fn point(line: &str) -> Option<(&str, &str, Point)> {
    let (names, numbers) = line.strip_prefix('"')?.split_once("\",")?;
    let (method, numbers) = numbers.strip_prefix('"')?.split_once("\",")?;
    let numbers: Result<Vec<f64>, _> = numbers.split(',').map(str::parse).collect();
    let [effort, time, error] = numbers.ok()?.try_into().ok()?;
    let point = Point {
        effort,
        time,
        error,
    };
    Some((names, method, point))
}

/// The problems, in the order in which they first come.
pub fn problems(curves: &[Curve]) -> Vec<&str> {
    let mut problems: Vec<&str> = Vec::new();
    for curve in curves {
        if !problems.contains(&curve.problem.as_str()) {
            problems.push(&curve.problem);
        }
    }
    problems
}

/// The curves as a table to read.
pub struct Table<'c>(pub &'c [Curve]);

impl fmt::Display for Table<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "ns for a simulated second of one body, to an error of, and in () by that of the {DOP853}"
        )?;
        for problem in problems(self.0) {
            write!(f, "\n{problem:<32}")?;
            for error in ERRORS {
                write!(f, "{error:>17e}")?;
            }
            writeln!(f, "{:>10}", "floor")?;
            let of_problem = || self.0.iter().filter(|curve| curve.problem == problem);
            let against = of_problem().find(|curve| curve.method == DOP853);
            for curve in of_problem() {
                row(f, curve, against)?;
            }
        }
        Ok(())
    }
}

fn row(f: &mut fmt::Formatter<'_>, curve: &Curve, against: Option<&Curve>) -> fmt::Result {
    write!(f, "  {:<30}", curve.method)?;
    for error in ERRORS {
        let time = curve.time_to(error);
        let against = against.and_then(|against| against.time_to(error));
        let words = match (time, against) {
            (None, _) => "-".into(),
            (Some(time), None) => short(time),
            (Some(time), Some(against)) => format!("{} ({:.2})", short(time), time / against),
        };
        write!(f, "{words:>17}")?;
    }
    writeln!(f, "{:>10.0e}", curve.floor())
}

/// Three digits.
fn short(time: f64) -> String {
    match time {
        100.0.. => format!("{time:.0}"),
        10.0.. => format!("{time:.1}"),
        1.0.. => format!("{time:.2}"),
        _ => format!("{time:.3}"),
    }
}
