//! Tables of one argument and of two.

#[path = "../../../interpolated/mod.rs"]
mod interpolated;

use crate::description::expression::{Course, Grid};
use crate::description::literal::Literal;

use super::number::Number;
use interpolated::{Knot, Real, curve, surface};

impl Real for Number {
    fn whole(n: i32) -> Self {
        Self::known(f64::from(n).into())
    }

    fn float(self) -> f64 {
        self.value.high
    }
}

fn known(literal: &Literal) -> Number {
    Number::known(literal.value)
}

fn way(course: Course) -> interpolated::Course {
    let Course {
        is_cubic,
        is_extrapolated,
    } = course;
    interpolated::Course {
        is_cubic,
        is_extrapolated,
    }
}

pub fn table(x: Number, rows: &[[Literal; 2]], course: Course) -> Number {
    let knots: Vec<Knot<Number>> = rows.iter().map(|row| row.each_ref().map(known)).collect();
    curve(x, &knots, way(course))
}

pub fn grid(at: [Number; 2], grid: &Grid, course: Course) -> Number {
    let list = |literals: &[Literal]| literals.iter().map(known).collect::<Vec<Number>>();
    let [along, across] = grid.places.each_ref().map(|places| list(places));
    let values: Vec<Vec<Number>> = grid.values.iter().map(|row| list(row)).collect();
    surface(at, [&along, &across], &values, way(course))
}
