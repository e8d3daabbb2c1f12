//! Loads with unknown components: what the balances of a known motion require of them.

use crate::description::body::{Key, Load, What};
use crate::description::expression::{Axes, Scalar};
use crate::wide::Wide;

use super::arithmetic::Values;
use super::loads::Wrench;
use super::number::Number;
use super::scene::Scene;
use super::vector::{Vector, dot};

/// A load that is known in part.
pub struct Open<'a> {
    pub index: usize,
    pub load: &'a Load,
    pub given: Wrench,
    /// A unit of each of the unknown components.
    units: Vec<Wrench>,
}

pub fn open_loads<'a>(scene: &Scene<'a>, reactions: bool) -> Vec<Open<'a>> {
    let loads = scene.constants.body.loads.iter().enumerate();
    let open =
        loads.filter(|(_, load)| load.is_open() && (load.key == Key::Reactions) == reactions);
    open.map(|(index, load)| Open::new(scene, index, load))
        .collect()
}

impl<'a> Open<'a> {
    fn new(scene: &Scene<'a>, index: usize, load: &'a Load) -> Self {
        let (axes, parts) = match &load.what {
            What::OpenForce(axes, parts, _) | What::OpenMoment(axes, parts) => (*axes, parts),
            other => unreachable!("{other:?} is known"),
        };
        let planar = scene.constants.body.motion.is_planar();
        let wrench = |components: [Number; 3], axes: Axes| {
            let vector = scene.written_in(axes, Vector::new(components));
            match &load.what {
                What::OpenForce(_, _, place) => Wrench::of_force(scene, vector, place),
                _ => Wrench::couple(vector),
            }
        };
        let known = |part: &Option<Scalar>| {
            part.as_ref()
                .map_or(Number::ZERO, |part| scene.scalar(part))
        };
        let given = wrench([0, 1, 2].map(|i| known(&parts[i])), axes);
        let is_unknown = |i: &usize| match load.what {
            What::OpenForce(..) => parts[*i].is_none() && (*i < 2 || !planar),
            _ => parts[*i].is_none() && (*i == 2 || !planar),
        };
        let unit = |i: usize| {
            let components = [0, 1, 2].map(|k| if k == i { Number::ONE } else { Number::ZERO });
            wrench(components, axes)
        };
        Self {
            index,
            load,
            given,
            units: (0..3).filter(is_unknown).map(unit).collect(),
        }
    }

    /// The axes in which it is written.
    pub fn axes(&self) -> Axes {
        match self.load.what {
            What::OpenForce(axes, ..) | What::OpenMoment(axes, ..) => axes,
            _ => Axes::World,
        }
    }

    /// Force or moment of a wrench, whichever this load is.
    pub fn part(&self, wrench: &Wrench) -> Vector {
        match self.load.what {
            What::OpenForce(..) => wrench.force,
            _ => wrench.about_center,
        }
    }
}

/// Which equations hold for the unknowns.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Equations {
    /// Both balances, moments about G.
    Both,
    /// Moments about the point that is held.
    Held,
    /// The moment about the axis through that point.
    Axis,
}

/// The loads for which the unknown parts sum to `missing`, in the order of `open`: of unknowns that are determined by more
/// equations than they are, which agree, the least squares.
pub fn solve(
    open: &[Open<'_>],
    missing: &Wrench,
    equations: Equations,
    axis: [Wide; 3],
) -> Vec<Vector> {
    let units: Vec<&Wrench> = open.iter().flat_map(|open| &open.units).collect();
    let rows = |wrench: &Wrench| -> Vec<Wide> {
        match equations {
            Equations::Both => [wrench.force.value, wrench.about_center.value].concat(),
            Equations::Held => wrench.about_held.value.to_vec(),
            Equations::Axis => vec![dot(axis, wrench.about_held.value)],
        }
    };
    let columns: Vec<Vec<Wide>> = units.iter().map(|unit| rows(unit)).collect();
    let inner = |a: &[Wide], b: &[Wide]| a.iter().zip(b).map(|(x, y)| *x * *y).sum::<Wide>();
    let n = columns.len();
    let normal = (0..n)
        .map(|i| (0..n).map(|j| inner(&columns[i], &columns[j])).collect())
        .collect();
    let inverse = inverted(normal);
    // of each unknown, how much of each equation
    let shares: Vec<Vec<Wide>> = (0..n)
        .map(|i| {
            let parts = 0..columns.first().map_or(0, Vec::len);
            let share = parts.map(|row| (0..n).map(|j| inverse[i][j] * columns[j][row]).sum());
            without_noise(share.collect())
        })
        .collect();
    let right = rows(missing);
    let numbers: Vec<Number> = shares
        .iter()
        .map(|share| Number::made(inner(share, &right), size(share, missing, equations), false))
        .collect();
    let mut numbers = numbers.into_iter();
    open.iter()
        .map(|open| {
            let start = open.part(&open.given);
            open.units.iter().fold(start, |sum, unit| {
                let number = numbers.next().expect("one for each unit");
                sum + open.part(unit).scaled(number)
            })
        })
        .collect()
}

/// What is nothing but rounding of the inverse is zero.
fn without_noise(share: Vec<Wide>) -> Vec<Wide> {
    let largest = share.iter().map(|x| x.high.abs()).fold(0.0, f64::max);
    let clean = |x: Wide| {
        if x.high.abs() < 1e-20 * largest {
            Wide::ZERO
        } else {
            x
        }
    };
    share.into_iter().map(clean).collect()
}

fn size(share: &[Wide], missing: &Wrench, equations: Equations) -> f64 {
    let norm = |parts: &[Wide]| parts.iter().map(|x| x.high.powi(2)).sum::<f64>().sqrt();
    match equations {
        Equations::Both => {
            let (of_force, of_moment) = share.split_at(3);
            (norm(of_force) * missing.force.size).max(norm(of_moment) * missing.about_center.size)
        }
        Equations::Held | Equations::Axis => norm(share) * missing.about_held.size,
    }
}

/// By Gauss and Jordan, of a matrix whose pivots do not vanish.
pub fn inverted(mut matrix: Vec<Vec<Wide>>) -> Vec<Vec<Wide>> {
    let n = matrix.len();
    for (i, row) in matrix.iter_mut().enumerate() {
        row.extend((0..n).map(|j| if i == j { Wide::ONE } else { Wide::ZERO }));
    }
    for i in 0..n {
        let pivot = matrix[i][i];
        for entry in &mut matrix[i] {
            *entry = *entry / pivot;
        }
        let line = matrix[i].clone();
        for (k, row) in matrix.iter_mut().enumerate() {
            let factor = row[i];
            if k != i {
                for (entry, of_line) in row.iter_mut().zip(&line) {
                    *entry = *entry - factor * *of_line;
                }
            }
        }
    }
    matrix.into_iter().map(|mut row| row.split_off(n)).collect()
}
