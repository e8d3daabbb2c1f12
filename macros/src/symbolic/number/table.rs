//! Tables: piecewise polynomials through given values.

use super::exact::Number;

/// A function of one number.
#[derive(Clone)]
pub struct Table {
    /// The pieces in order; the first one also holds below its start.
    pub pieces: Vec<Piece>,
}

/// A polynomial that holds from `start` on.
#[derive(Clone)]
pub struct Piece {
    pub start: Number,
    /// The coefficients of the powers of the distance from the start.
    pub coefficients: Vec<Number>,
}

impl Piece {
    pub fn value(&self, x: &Number) -> Number {
        let beyond = x.clone() - self.start.clone();
        let coefficients = self.coefficients.iter().rev();
        coefficients.fold(Number::zero(), |sum, one| {
            sum * beyond.clone() + one.clone()
        })
    }
}

/// A point of a table.
pub type Knot = (Number, Number);

impl Table {
    /// Straight lines from each knot to the next; `None` if two knots are at the same place.
    pub fn linear(knots: &[Knot], is_extrapolated: bool) -> Option<Self> {
        let pieces = knots.windows(2).map(|pair| {
            let [(start, value), (end, next)] = pair else {
                return None;
            };
            let rise = next.clone() - value.clone();
            let slope = rise.checked_div(&(end.clone() - start.clone()))?;
            Some(Piece {
                start: start.clone(),
                coefficients: vec![value.clone(), slope],
            })
        });
        Some(Self::held(
            pieces.collect::<Option<_>>()?,
            knots,
            is_extrapolated,
        ))
    }

    /// Cubics with one slope at each knot, monotone where the values are.
    pub fn cubic(knots: &[Knot], is_extrapolated: bool) -> Option<Self> {
        Self::hermite(knots, &Self::slopes(knots)?, is_extrapolated)
    }

    /// The slopes of monotone cubics (Fritsch and Carlson, Monotone Piecewise Cubic Interpolation,
    /// SIAM J. Numer. Anal. 17, 1980, 238): the slope of the parabola through three knots, limited
    /// to three times that of either adjacent line.
    pub fn slopes(knots: &[Knot]) -> Option<Vec<Number>> {
        let lines = lines(knots)?;
        let slopes = (0..knots.len()).map(|knot| slope_at(&lines, knot));
        slopes.collect()
    }

    /// Cubics with these slopes at the knots.
    pub fn hermite(knots: &[Knot], slopes: &[Number], is_extrapolated: bool) -> Option<Self> {
        let lines = lines(knots)?;
        let pieces = lines.iter().zip(knots).zip(slopes.windows(2));
        let pieces = pieces.map(|(((width, line), (start, value)), slopes)| {
            let (first, second) = (slopes[0].clone(), slopes[1].clone());
            let whole = |factor: i64, number: &Number| Number::integer(factor) * number.clone();
            let square = whole(3, line) - whole(2, &first) - second.clone();
            let cube = first.clone() + second - whole(2, line);
            Some(Piece {
                start: start.clone(),
                coefficients: vec![
                    value.clone(),
                    first,
                    square.checked_div(width)?,
                    cube.checked_div(&(width.clone() * width.clone()))?,
                ],
            })
        });
        Some(Self::held(
            pieces.collect::<Option<_>>()?,
            knots,
            is_extrapolated,
        ))
    }

    /// Beyond the knots, holds the values at the ends or continues the polynomials there.
    fn held(mut pieces: Vec<Piece>, knots: &[Knot], is_extrapolated: bool) -> Self {
        if !is_extrapolated {
            let ends = [knots.first(), knots.last()];
            let ends = ends.map(|knot| {
                knot.map(|(start, value)| Piece {
                    start: start.clone(),
                    coefficients: vec![value.clone()],
                })
            });
            let [first, last] = ends;
            pieces.splice(0..0, first);
            pieces.extend(last);
        }
        Self { pieces }
    }

    pub fn value(&self, x: &Number) -> Number {
        let mut pieces = self.pieces.iter().enumerate().rev();
        let found = pieces.find(|(place, piece)| {
            let below = x.clone() - piece.start.clone();
            *place == 0 || !below.is_negative()
        });
        found.map_or(Number::zero(), |(_, piece)| piece.value(x))
    }

    /// The value in doubles.
    pub fn rounded(&self, x: f64) -> f64 {
        let mut pieces = self.pieces.iter().enumerate().rev();
        let found = pieces.find(|(place, piece)| *place == 0 || piece.start.to_f64() <= x);
        found.map_or(f64::NAN, |(_, piece)| {
            let coefficients = piece.coefficients.iter().rev();
            let beyond = x - piece.start.to_f64();
            coefficients.fold(0.0, |sum, one| sum * beyond + one.to_f64())
        })
    }

    /// The derivative of this order, piece by piece.
    pub fn derivative(&self, order: usize) -> Self {
        let mut pieces = self.pieces.clone();
        for _ in 0..order {
            for piece in &mut pieces {
                let old = piece.coefficients.drain(..).enumerate().skip(1);
                let new = old.map(|(power, one)| {
                    let power = i64::try_from(power).unwrap_or(0);
                    Number::integer(power) * one
                });
                piece.coefficients = new.collect();
            }
        }
        Self { pieces }
    }
}

/// The width and the slope of the line from each knot to the next.
fn lines(knots: &[Knot]) -> Option<Vec<(Number, Number)>> {
    let lines = knots.windows(2).map(|pair| {
        let width = pair[1].0.clone() - pair[0].0.clone();
        let rise = pair[1].1.clone() - pair[0].1.clone();
        Some((width.clone(), rise.checked_div(&width)?))
    });
    lines.collect()
}

/// The slope at a knot, from the widths and slopes of the two adjacent lines.
fn slope_at(lines: &[(Number, Number)], knot: usize) -> Option<Number> {
    let before = knot.checked_sub(1).and_then(|place| lines.get(place));
    let (slope, beside) = match (before, lines.get(knot)) {
        (Some((h, d)), Some((k, e))) => {
            let sum = k.clone() * d.clone() + h.clone() * e.clone();
            let slope = sum.checked_div(&(h.clone() + k.clone()))?;
            (slope, vec![d, e])
        }
        (None, Some(first)) => (slope_at_end(first, lines.get(1))?, vec![&first.1]),
        (Some(last), None) => {
            let other = knot.checked_sub(2).and_then(|place| lines.get(place));
            (slope_at_end(last, other)?, vec![&last.1])
        }
        (None, None) => return None,
    };
    Some(beside.into_iter().fold(slope, limited))
}

/// The slope of the parabola through the three knots at an end.
fn slope_at_end((h, d): &(Number, Number), next: Option<&(Number, Number)>) -> Option<Number> {
    let Some((k, e)) = next else {
        return Some(d.clone());
    };
    let change = h.clone() * (d.clone() - e.clone());
    Some(d.clone() + change.checked_div(&(h.clone() + k.clone()))?)
}

/// A slope limited to the sign of that of a line and to three times its steepness.
fn limited(slope: Number, line: &Number) -> Number {
    let most = Number::integer(3) * line.clone();
    let is_against = slope.is_negative() != line.is_negative();
    if line.is_zero() || is_against {
        return Number::zero();
    }
    let is_steeper = (slope.abs() - most.abs()).is_positive();
    if is_steeper { most } else { slope }
}
