//! The values of tables: straight lines, and Hermite cubics with the slopes of Fritsch and Carlson.

use std::ops::{Add, Div, Mul, Sub};

/// Numbers of any precision.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// A whole number.
    fn whole(n: i32) -> Self;

    /// The nearest double.
    fn float(self) -> f64;
}

/// How a table goes between its places and beyond them.
#[derive(Clone, Copy, Debug)]
pub struct Course {
    pub is_cubic: bool,
    pub is_extrapolated: bool,
}

/// A place, and what is there.
pub type Knot<N> = [N; 2];

/// On the line, or the cubic, between the two places beside it.
pub fn curve<N: Real>(x: N, knots: &[Knot<N>], course: Course) -> N {
    if course.is_cubic {
        return cubic(x, knots, &slopes(knots), course);
    }
    let (piece, beyond) = match piece(x, knots, course) {
        Ok(found) => found,
        Err(held) => return held,
    };
    knots[piece][1] + line(&knots[piece..]) * beyond
}

/// In each row a table of y; across the rows one of x, whose slopes are such tables, too.
pub fn surface<N: Real>(
    [x, y]: [N; 2],
    [along, across]: [&[N]; 2],
    values: &[Vec<N>],
    course: Course,
) -> N {
    let paired = |places: &[N], values: &[N]| -> Vec<Knot<N>> {
        let pairs = places.iter().zip(values);
        pairs.map(|(place, value)| [*place, *value]).collect()
    };
    let at_y = |row: &[N]| curve(y, &paired(across, row), course);
    let rows: Vec<N> = values.iter().map(|row| at_y(row)).collect();
    let knots = paired(along, &rows);
    if !course.is_cubic {
        return curve(x, &knots, course);
    }
    let columns = (0..across.len()).map(|column| {
        let column: Vec<N> = values.iter().map(|row| row[column]).collect();
        slopes(&paired(along, &column))
    });
    let columns: Vec<Vec<N>> = columns.collect();
    let slope = |row: usize| {
        let row: Vec<N> = columns.iter().map(|column| column[row]).collect();
        at_y(&row)
    };
    let slopes: Vec<N> = (0..knots.len()).map(slope).collect();
    cubic(x, &knots, &slopes, course)
}

/// The piece for it and how far it is beyond the start of that, or the value that is held there.
fn piece<N: Real>(x: N, knots: &[Knot<N>], course: Course) -> Result<(usize, N), N> {
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
fn line<N: Real>(knots: &[Knot<N>]) -> N {
    let [[from, start], [to, end]] = [knots[0], knots[1]];
    (end - start) / (to - from)
}

/// Hermite's cubic.
fn cubic<N: Real>(x: N, knots: &[Knot<N>], slopes: &[N], course: Course) -> N {
    let (piece, beyond) = match piece(x, knots, course) {
        Ok(found) => found,
        Err(held) => return held,
    };
    let (line, width) = (line(&knots[piece..]), knots[piece + 1][0] - knots[piece][0]);
    let [first, second] = [slopes[piece], slopes[piece + 1]];
    let square = (N::whole(3) * line - N::whole(2) * first - second) / width;
    let cube = (first + second - N::whole(2) * line) / (width * width);
    knots[piece][1] + beyond * (first + beyond * (square + beyond * cube))
}

/// Those of parabolas through three places, of the sign of the lines beside them, and at most three
/// times as steep.
fn slopes<N: Real>(knots: &[Knot<N>]) -> Vec<N> {
    let last = knots.len() - 1;
    let lines: Vec<N> = (0..last).map(|i| line(&knots[i..])).collect();
    let widths: Vec<N> = (0..last).map(|i| knots[i + 1][0] - knots[i][0]).collect();
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

fn limited<N: Real>(slope: N, beside: &[N]) -> N {
    beside.iter().fold(slope, |slope, line| {
        if line.float() * slope.float() <= 0.0 {
            N::whole(0)
        } else if slope.float().abs() > 3.0 * line.float().abs() {
            N::whole(3) * *line
        } else {
            slope
        }
    })
}
