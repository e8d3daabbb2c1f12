//! What does not change during a run: everything that depends on parameters alone.

use std::cell::Cell;

use crate::description::body::{Body, Motion};
use crate::description::expression::{Axes, Place, Scalar};
use crate::given::Given;
use crate::wide::Wide;

use super::arithmetic::Values;
use super::inertia::{Components, Tensor, plus, steiner, sum, whole};
use super::number::Number;
use super::vector::dot;

/// Numbers of a body with its parameters given.
pub struct Constants<'a> {
    pub body: &'a Body,
    pub params: Vec<Wide>,
    pub param_offsets: Vec<usize>,
    pub input_offsets: Vec<usize>,
    pub mass: Number,
    /// From G where they are in the body, from the world's origin in space.
    pub points: Vec<Components>,
    /// About G, or about the point that is held.
    pub inertia: Solved,
    /// About G.
    pub tensor: Tensor,
    /// From the point that is held to G, body axes.
    pub held_to_center: Components,
    pub anchor: Components,
    /// The unit vector that a hinge turns about, or that a rod lies along.
    pub direction: [Wide; 3],
}

/// A tensor with its inverse.
pub struct Solved {
    pub value: [[Wide; 3]; 3],
    pub size: f64,
    pub known: bool,
    pub inverse: [[Wide; 3]; 3],
    /// Norm of the inverse.
    pub inverse_size: f64,
}

/// Scalars that are made of literals and parameters.
struct Early<'a> {
    params: &'a [Wide],
    own: &'a [Wide],
    offsets: &'a [usize],
    mass: Option<Number>,
    near_switch: Cell<bool>,
}

impl Values for Early<'_> {
    fn scalar(&self, scalar: &Scalar) -> Number {
        match scalar {
            Scalar::Param(i) => Number::exactly(self.params[self.offsets[*i]]),
            Scalar::State(i) => Number::exactly(self.own[*i]),
            Scalar::Mass => self.mass.expect("the mass is not made of itself"),
            other => self.operation(other),
        }
    }

    fn near_switch(&self) -> &Cell<bool> {
        &self.near_switch
    }
}

impl<'a> Constants<'a> {
    pub fn new(body: &'a Body, params: &[f64]) -> Self {
        let own = vec![Wide::ZERO; body.rates.len()];
        Self::with_states(body, exactly(params), &own)
    }

    /// In a state.
    pub fn now(body: &'a Body, given: &Given) -> Self {
        Self::with_states(body, exactly(&given.params), &exactly(&given.own))
    }

    /// Of a body whose mass and inertia follow its own states.
    pub fn with_states(body: &'a Body, params: Vec<Wide>, own: &[Wide]) -> Self {
        let (param_offsets, _) = body.param_offsets();
        let mut early = Early {
            params: &params,
            own,
            offsets: &param_offsets,
            mass: None,
            near_switch: Cell::new(false),
        };
        early.mass = body.mass.as_ref().map(|mass| early.scalar(mass));
        let read = |components: &[Scalar; 3]| [0, 1, 2].map(|i| early.scalar(&components[i]));
        let drawn: Vec<Components> = body
            .points
            .iter()
            .map(|point| read(&point.coordinates))
            .collect();
        let place = |place: &Place| match place {
            Place::Named(i) => drawn[*i],
            _ => [Number::ZERO; 3],
        };
        let whole = whole(body, &early, &place);
        let points: Vec<Components> = body
            .points
            .iter()
            .zip(&drawn)
            .map(|(point, at)| match point.axes {
                Axes::Body => [0, 1, 2].map(|i| at[i] - whole.center[i]),
                Axes::World => *at,
            })
            .collect();
        let support = body.motion.support();
        let held_to_center = support.map_or([Number::ZERO; 3], |support| {
            points[support.point].map(|x| -x)
        });
        let anchor = support
            .and_then(|support| support.anchor.as_ref())
            .map_or([Number::ZERO; 3], read);
        let direction = match &body.motion {
            Motion::FixedAxis(_, _, direction) | Motion::Rod(direction) => {
                let d = read(direction).map(|x| x.value);
                let length = dot(d, d).sqrt();
                d.map(|x| x / length)
            }
            _ => [Wide::ZERO, Wide::ZERO, Wide::ONE],
        };
        let about_held = plus(&whole.tensor, &steiner(whole.mass, held_to_center));
        Self {
            inertia: Solved::new(&about_held),
            tensor: whole.tensor,
            mass: whole.mass,
            points,
            held_to_center,
            anchor,
            direction,
            body,
            param_offsets: param_offsets.clone(),
            input_offsets: body.input_offsets().0,
            params,
        }
    }

    /// The one moment of inertia of a rod.
    pub fn across(&self) -> Number {
        sum((0..3).map(|i| self.tensor[i][i])) / Number::known(Wide::from(2.0))
    }
}

impl Solved {
    fn new(tensor: &Tensor) -> Self {
        let value = tensor.map(|row| row.map(|entry| entry.value));
        let entries = || tensor.iter().flatten();
        let size = entries()
            .map(|entry| entry.span().powi(2))
            .sum::<f64>()
            .sqrt();
        let inverse = inverse(&value);
        let squares = inverse.iter().flatten().map(|entry| entry.high.powi(2));
        Self {
            value,
            size,
            known: entries().all(|entry| entry.known),
            inverse,
            inverse_size: squares.sum::<f64>().sqrt(),
        }
    }

    /// How much of the last digits the inverse may take.
    pub fn condition(&self) -> f64 {
        self.size * self.inverse_size
    }
}

pub fn exactly(numbers: &[f64]) -> Vec<Wide> {
    numbers.iter().map(|number| Wide::from(*number)).collect()
}

pub fn multiplied(matrix: &[[Wide; 3]; 3], vector: [Wide; 3]) -> [Wide; 3] {
    matrix.map(|row| dot(row, vector))
}

/// By cofactors; of a singular matrix not finite.
fn inverse(m: &[[Wide; 3]; 3]) -> [[Wide; 3]; 3] {
    let cofactor = |i: usize, j: usize| {
        let [a, b] = [(i + 1) % 3, (i + 2) % 3];
        let [c, d] = [(j + 1) % 3, (j + 2) % 3];
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    let determinant = (0..3).map(|j| m[0][j] * cofactor(0, j)).sum::<Wide>();
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| cofactor(j, i) / determinant))
}
