//! The mass, center of mass and inertia of a description, by the formulas of any handbook.

use crate::description::body::{Body, Inertia, Part, Solid};
use crate::description::expression::{Place, Scalar, Unary};

use super::arithmetic::Values;
use super::number::Number;

pub type Components = [Number; 3];
pub type Tensor = [[Number; 3]; 3];

pub struct Whole {
    pub mass: Number,
    /// From the drawing origin.
    pub center: Components,
    /// About the center of mass, body axes. Of a rod along the last of the axes; in the plane only the last entry counts.
    pub tensor: Tensor,
}

const ORIGIN: Components = [Number::ZERO; 3];
const NONE: Tensor = [ORIGIN; 3];

/// `place` reads a point of the description.
pub fn whole(body: &Body, values: &impl Values, place: &dyn Fn(&Place) -> Components) -> Whole {
    let read = Read {
        body,
        values,
        place,
    };
    let mass = body
        .mass
        .as_ref()
        .map_or(Number::ZERO, |mass| values.scalar(mass));
    match &body.inertia {
        None => Whole {
            mass,
            center: ORIGIN,
            tensor: NONE,
        },
        Some(Inertia::Compose(parts)) => read.composed(parts),
        Some(inertia) => Whole {
            mass,
            center: ORIGIN,
            tensor: read.tensor(inertia, mass),
        },
    }
}

struct Read<'a, V> {
    body: &'a Body,
    values: &'a V,
    place: &'a dyn Fn(&Place) -> Components,
}

impl<V: Values> Read<'_, V> {
    fn scalars<const N: usize>(&self, scalars: &[Scalar; N]) -> [Number; N] {
        std::array::from_fn(|i| self.values.scalar(&scalars[i]))
    }

    fn composed(&self, parts: &[Part]) -> Whole {
        let parts: Vec<(Number, Components, Tensor)> = parts
            .iter()
            .map(|part| {
                let mass = self.values.scalar(&part.mass);
                let tensor = part
                    .inertia
                    .as_ref()
                    .map_or(NONE, |inertia| self.tensor(inertia, mass));
                (mass, (self.place)(&part.at), tensor)
            })
            .collect();
        let mass = sum(parts.iter().map(|(mass, ..)| *mass));
        let center = [0, 1, 2].map(|i| sum(parts.iter().map(|(mass, at, _)| *mass * at[i])) / mass);
        let tensor = parts.iter().fold(NONE, |tensor, (mass, at, own)| {
            let offset = [0, 1, 2].map(|i| at[i] - center[i]);
            plus(&plus(&tensor, own), &steiner(*mass, offset))
        });
        Whole {
            mass,
            center,
            tensor,
        }
    }

    fn tensor(&self, inertia: &Inertia, mass: Number) -> Tensor {
        match inertia {
            Inertia::Scalar(moment) if self.body.motion.is_planar() => {
                diagonal([Number::ZERO, Number::ZERO, self.values.scalar(moment)])
            }
            Inertia::Scalar(moment) => {
                let moment = self.values.scalar(moment);
                diagonal([moment, moment, Number::ZERO])
            }
            Inertia::Principal(moments) => diagonal(self.scalars(moments)),
            Inertia::Tensor(entries) => symmetric(self.scalars(entries)),
            Inertia::Products(entries) => {
                let [xx, yy, zz, xy, yz, zx] = self.scalars(entries);
                symmetric([xx, yy, zz, -xy, -yz, -zx])
            }
            Inertia::Solid(solid, lengths) => {
                let lengths: Vec<Number> = lengths
                    .iter()
                    .map(|length| self.values.scalar(length))
                    .collect();
                let moments = if self.body.motion.is_planar() && *solid == Solid::Rod {
                    let [_, across, _] = per_mass(*solid, &lengths);
                    [Number::ZERO, across, across]
                } else {
                    per_mass(*solid, &lengths)
                };
                diagonal(moments.map(|moment| mass * moment))
            }
            Inertia::Along(inner, direction) => {
                let inner = self.tensor(inner, mass);
                let [d, square] = self.direction(direction);
                let (across, axial) = (inner[0][0], inner[2][2]);
                [0, 1, 2].map(|i| {
                    [0, 1, 2].map(|j| {
                        let own = if i == j { across } else { Number::ZERO };
                        own + (axial - across) * d[i] * d[j] / square[0]
                    })
                })
            }
            Inertia::Turned(inner, axis, angle) => {
                let inner = self.tensor(inner, mass);
                let [axis, square] = self.direction(axis);
                let length = square[0].apply_root(square[0].size.sqrt());
                let axis = axis.map(|x| x / length);
                turned(&inner, &turn(axis, self.values.scalar(angle)))
            }
            Inertia::About(inner, place) => {
                let inner = self.tensor(inner, mass);
                plus(&inner, &steiner(-mass, (self.place)(place)))
            }
            Inertia::Compose(_) => unreachable!("is the whole of a body"),
        }
    }

    /// A direction, and the square of its length.
    fn direction(&self, direction: &[Scalar; 3]) -> [Components; 2] {
        let d = self.scalars(direction);
        [d, [sum(d.iter().map(|x| x.squared())); 3]]
    }
}

fn number(x: f64) -> Number {
    Number::known(x.into())
}

fn per_mass(solid: Solid, lengths: &[Number]) -> Components {
    let square = |i: usize| lengths[i].squared();
    let axial = |across: Number, along: Number| [across, across, along];
    match solid {
        Solid::Cuboid => {
            let [a, b, c] = [0, 1, 2].map(square);
            [b + c, c + a, a + b].map(|sum| sum / number(12.0))
        }
        Solid::Ellipsoid => {
            let [a, b, c] = [0, 1, 2].map(square);
            [b + c, c + a, a + b].map(|sum| sum / number(5.0))
        }
        Solid::Sphere => [number(2.0) * square(0) / number(5.0); 3],
        Solid::Shell => [number(2.0) * square(0) / number(3.0); 3],
        Solid::Cylinder => axial(
            (number(3.0) * square(0) + square(1)) / number(12.0),
            square(0) / number(2.0),
        ),
        Solid::Tube => {
            let radii = square(0) + square(1);
            axial(
                (number(3.0) * radii + square(2)) / number(12.0),
                radii / number(2.0),
            )
        }
        Solid::Cone => axial(
            number(3.0) * square(0) / number(20.0) + number(3.0) * square(1) / number(80.0),
            number(3.0) * square(0) / number(10.0),
        ),
        Solid::Torus => axial(
            square(0) / number(2.0) + number(5.0) * square(1) / number(8.0),
            square(0) + number(3.0) * square(1) / number(4.0),
        ),
        Solid::Disc => axial(square(0) / number(4.0), square(0) / number(2.0)),
        Solid::Rod => axial(square(0) / number(12.0), Number::ZERO),
    }
}

/// `m (r² 1 - r rᵀ)`
pub fn steiner(mass: Number, r: Components) -> Tensor {
    [0, 1, 2].map(|i| {
        [0, 1, 2].map(|j| {
            if i == j {
                let others = [(i + 1) % 3, (i + 2) % 3].map(|k| r[k].squared());
                mass * (others[0] + others[1])
            } else {
                -(mass * r[i] * r[j])
            }
        })
    })
}

pub fn plus(a: &Tensor, b: &Tensor) -> Tensor {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| a[i][j] + b[i][j]))
}

/// By Rodrigues, about a unit vector.
pub fn turn(axis: Components, angle: Number) -> Tensor {
    let (sine, cosine) = (angle.apply(Unary::Sin), angle.apply(Unary::Cos));
    let [x, y, z] = axis;
    let skew = [
        [Number::ZERO, -z, y],
        [z, Number::ZERO, -x],
        [-y, x, Number::ZERO],
    ];
    [0, 1, 2].map(|i| {
        [0, 1, 2].map(|j| {
            let own = if i == j { cosine } else { Number::ZERO };
            own + sine * skew[i][j] + (Number::ONE - cosine) * axis[i] * axis[j]
        })
    })
}

/// `R J Rᵀ`
fn turned(tensor: &Tensor, r: &Tensor) -> Tensor {
    let half = [0, 1, 2].map(|i| [0, 1, 2].map(|j| sum((0..3).map(|k| r[i][k] * tensor[k][j]))));
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| sum((0..3).map(|k| half[i][k] * r[j][k]))))
}

fn diagonal([a, b, c]: Components) -> Tensor {
    let zero = Number::ZERO;
    [[a, zero, zero], [zero, b, zero], [zero, zero, c]]
}

fn symmetric([xx, yy, zz, xy, yz, zx]: [Number; 6]) -> Tensor {
    [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]
}

pub fn sum(numbers: impl Iterator<Item = Number>) -> Number {
    numbers.fold(Number::ZERO, |sum, number| sum + number)
}
