//! Tables of one scalar and of two.

use crate::description::expression::{Course, Grid};
use crate::description::literal::Literal;

use super::number::Number;

/// A place, and what is there.
type Knot = [Number; 2];

fn known(literal: &Literal) -> Number {
    Number::known(literal.value)
}

pub fn table(x: Number, rows: &[[Literal; 2]], course: Course) -> Number {
    let knots: Vec<Knot> = rows.iter().map(|row| row.each_ref().map(known)).collect();
    curve(x, &knots, course)
}

/// In each row a table of y; across the rows one of x, whose slopes are such tables, too.
pub fn grid([x, y]: [Number; 2], grid: &Grid, course: Course) -> Number {
    let [along, across] = grid
        .places
        .each_ref()
        .map(|places| places.iter().map(known));
    let values = grid
        .values
        .iter()
        .map(|row| row.iter().map(known).collect());
    let values: Vec<Vec<Number>> = values.collect();
    let at_y = |row: Vec<Number>| {
        let places = across.clone();
        let knots: Vec<Knot> = places
            .zip(row)
            .map(|(place, value)| [place, value])
            .collect();
        curve(y, &knots, course)
    };
    let rows = along.clone().zip(values.clone());
    let knots: Vec<Knot> = rows.map(|(place, row)| [place, at_y(row)]).collect();
    if !course.is_cubic {
        return curve(x, &knots, course);
    }
    let columns = (0..values[0].len()).map(|column| {
        let column = values.iter().map(|row| row[column]);
        let knots: Vec<Knot> = along
            .clone()
            .zip(column)
            .map(|(place, value)| [place, value])
            .collect();
        slopes(&knots)
    });
    let columns: Vec<Vec<Number>> = columns.collect();
    let slope = |row: usize| at_y(columns.iter().map(|column| column[row]).collect());
    let slopes: Vec<Number> = (0..knots.len()).map(slope).collect();
    cubic(x, &knots, &slopes, course)
}

/// On the line, or the cubic, between the two places beside it.
fn curve(x: Number, knots: &[Knot], course: Course) -> Number {
    if course.is_cubic {
        return cubic(x, knots, &slopes(knots), course);
    }
    let (piece, beyond) = match piece(x, knots, course) {
        Ok(found) => found,
        Err(held) => return held,
    };
    knots[piece][1] + line(&knots[piece..]) * beyond
}

/// The piece for it and how far it is beyond the start of that, or the value that is held there.
fn piece(x: Number, knots: &[Knot], course: Course) -> Result<(usize, Number), Number> {
    let last = knots.len() - 1;
    let [low, high] = [knots[0], knots[last]];
    let is_held = !course.is_extrapolated;
    if is_held && x.float() <= low[0].float() {
        return Err(low[1]);
    }
    if is_held && x.float() >= high[0].float() {
        return Err(high[1]);
    }
    let inner = knots[1..last].iter();
    let piece = inner.filter(|knot| knot[0].float() < x.float()).count();
    Ok((piece, x - knots[piece][0]))
}

/// The slope of the line from the first to the second.
fn line(knots: &[Knot]) -> Number {
    let [[from, start], [to, end]] = [knots[0], knots[1]];
    (end - start) / (to - from)
}

/// Hermite's cubic.
fn cubic(x: Number, knots: &[Knot], slopes: &[Number], course: Course) -> Number {
    let (piece, beyond) = match piece(x, knots, course) {
        Ok(found) => found,
        Err(held) => return held,
    };
    let whole = |n: i32| Number::known(f64::from(n).into());
    let (line, width) = (line(&knots[piece..]), knots[piece + 1][0] - knots[piece][0]);
    let [first, second] = [slopes[piece], slopes[piece + 1]];
    let square = (whole(3) * line - whole(2) * first - second) / width;
    let cube = (first + second - whole(2) * line) / (width * width);
    knots[piece][1] + beyond * (first + beyond * (square + beyond * cube))
}

/// Those of parabolas through three places, of the sign of the lines beside them, and at most three
/// times as steep.
fn slopes(knots: &[Knot]) -> Vec<Number> {
    let last = knots.len() - 1;
    let lines: Vec<Number> = (0..last).map(|i| line(&knots[i..])).collect();
    let widths: Vec<Number> = (0..last).map(|i| knots[i + 1][0] - knots[i][0]).collect();
    let at_end = |end: usize, next: usize| {
        let outer = widths[end] / (widths[end] + widths[next]);
        lines[end] + outer * (lines[end] - lines[next])
    };
    let slope = |i: usize| {
        if last == 1 {
            return lines[0];
        }
        if i == 0 {
            return limited(at_end(0, 1), &lines[..1]);
        }
        if i == last {
            return limited(at_end(last - 1, last - 2), &lines[last - 1..]);
        }
        let (before, after) = (widths[i - 1], widths[i]);
        let sum = after * lines[i - 1] + before * lines[i];
        limited(sum / (before + after), &lines[i - 1..=i])
    };
    (0..=last).map(slope).collect()
}

fn limited(slope: Number, beside: &[Number]) -> Number {
    let three = Number::known(3.0.into());
    beside.iter().fold(slope, |slope, line| {
        if line.float() * slope.float() <= 0.0 {
            Number::ZERO
        } else if slope.float().abs() > 3.0 * line.float().abs() {
            three * *line
        } else {
            slope
        }
    })
}
