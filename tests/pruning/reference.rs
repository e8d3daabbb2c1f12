//! The vector law, unpruned, with scalars that count their operations and remember their terms.
//!
//! Everything is in space, with a full tensor, and with every force rotated into both axes:
//! `a = F / m`, `w' = J^-1 (M - w x J w)`, with J^-1 from the adjugate.

use core::cell::Cell;
use core::ops::{Add, Div, Mul, Sub};

use crate::coordinates::Coordinates;

thread_local! {
    static OPERATIONS: Cell<u32> = const { Cell::new(0) };
}

/// How many operations a computation takes.
pub fn operations(computation: impl FnOnce()) -> u32 {
    OPERATIONS.set(0);
    computation();
    OPERATIONS.get()
}

fn count() {
    OPERATIONS.set(OPERATIONS.get() + 1);
}

/// A number, and how large the largest of the terms is that it was summed from.
#[derive(Clone, Copy, Debug)]
pub struct Traced {
    pub value: f64,
    pub largest: f64,
}

impl From<f64> for Traced {
    fn from(value: f64) -> Self {
        Self {
            value,
            largest: value.abs(),
        }
    }
}

impl Add for Traced {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        count();
        Self {
            value: self.value + other.value,
            largest: self.largest.max(other.largest),
        }
    }
}

impl Sub for Traced {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        count();
        Self {
            value: self.value - other.value,
            largest: self.largest.max(other.largest),
        }
    }
}

impl Mul for Traced {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        count();
        Self {
            value: self.value * other.value,
            largest: self.largest * other.largest,
        }
    }
}

/// What canceled in the divisor is missing in all digits of the quotient.
impl Div for Traced {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        count();
        Self {
            value: self.value / other.value,
            largest: self.largest * other.largest / (other.value * other.value),
        }
    }
}

pub type Triple = [Traced; 3];
pub type Matrix = [Triple; 3];

fn triple(v: [f64; 3]) -> Triple {
    v.map(Traced::from)
}

fn plus(a: Triple, b: Triple) -> Triple {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn minus(a: Triple, b: Triple) -> Triple {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Triple, b: Triple) -> Traced {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Triple, b: Triple) -> Triple {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
}

fn product(matrix: &Matrix, v: Triple) -> Triple {
    matrix.map(|row| dot(row, v))
}

fn transposed(m: &Matrix) -> Matrix {
    [0, 1, 2].map(|i| [m[0][i], m[1][i], m[2][i]])
}

/// Adjugate over determinant, of a symmetric matrix.
fn inverse(m: &Matrix) -> Matrix {
    let adjugate = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])];
    let determinant = dot(m[0], adjugate[0]);
    adjugate.map(|row| row.map(|entry| entry / determinant))
}

/// Of a unit quaternion.
fn rotation(w: Traced, v: Triple) -> Matrix {
    let two = Traced::from(2.0);
    let one = Traced::from(1.0);
    let [x, y, z] = v;
    [
        [
            one - two * (y * y + z * z),
            two * (x * y - w * z),
            two * (x * z + w * y),
        ],
        [
            two * (x * y + w * z),
            one - two * (z * z + x * x),
            two * (y * z - w * x),
        ],
        [
            two * (x * z - w * y),
            two * (y * z + w * x),
            one - two * (x * x + y * y),
        ],
    ]
}

/// Axes in which a load is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Axes {
    Body,
    World,
}
pub use Axes::{Body, World};

/// A force at a point of the body, from G, and a moment.
#[derive(Clone, Copy, Debug)]
pub struct Push {
    pub axes: Axes,
    pub force: [f64; 3],
    pub at: [f64; 3],
    pub moment: [f64; 3],
}

pub fn force(axes: Axes, force: [f64; 3], at: [f64; 3]) -> Push {
    Push {
        axes,
        force,
        at,
        moment: [0.0; 3],
    }
}

pub fn moment(axes: Axes, moment: [f64; 3]) -> Push {
    Push {
        axes,
        force: [0.0; 3],
        at: [0.0; 3],
        moment,
    }
}

/// What holds a body.
#[derive(Clone, Copy, Debug)]
pub enum Support {
    Free,
    /// Nothing turns it.
    Guided,
    /// A point of it, from G.
    Point([f64; 3]),
    /// An axis, a unit vector, through a point.
    Axis([f64; 3], [f64; 3]),
}

/// A body and what acts on it.
#[derive(Clone, Debug)]
pub struct Scene {
    pub support: Support,
    pub mass: f64,
    pub inertia: [[f64; 3]; 3],
    pub pushes: Vec<Push>,
}

pub fn principal(moments: [f64; 3]) -> [[f64; 3]; 3] {
    let [a, b, c] = moments;
    [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]]
}

impl Scene {
    /// Linear and angular acceleration.
    pub fn accelerations(&self, c: &Coordinates) -> [Triple; 2] {
        let q = match self.support {
            Support::Axis(_, [x, y, z]) => {
                let (sine, cosine) = (0.5 * c.angle).sin_cos();
                [cosine, sine * x, sine * y, sine * z]
            }
            _ => [c.attitude.w, c.attitude.i, c.attitude.j, c.attitude.k],
        };
        let [qw, qx, qy, qz] = q.map(Traced::from);
        let to_world = rotation(qw, [qx, qy, qz]);
        let to_body = transposed(&to_world);
        let held = match self.support {
            Support::Point(at) | Support::Axis(at, _) => triple(at),
            Support::Free | Support::Guided => triple([0.0; 3]),
        };
        let (mut total, mut about) = (triple([0.0; 3]), triple([0.0; 3]));
        for push in &self.pushes {
            let (force, moment) = (triple(push.force), triple(push.moment));
            let (in_body, in_world, moment) = match push.axes {
                Body => (force, product(&to_world, force), moment),
                World => (product(&to_body, force), force, product(&to_body, moment)),
            };
            total = plus(total, in_world);
            about = plus(about, cross(minus(triple(push.at), held), in_body));
            about = plus(about, moment);
        }
        let mass = Traced::from(self.mass);
        let linear = total.map(|component| component / mass);

        let inertia = self.inertia_about(mass, held);
        let angular = match self.support {
            Support::Guided => triple([0.0; 3]),
            Support::Axis(_, direction) => {
                let d = triple(direction);
                let spin = Traced::from(c.angular_velocity.z);
                let w = d.map(|part| part * spin);
                let net = minus(about, cross(w, product(&inertia, w)));
                let zero = Traced::from(0.0);
                [zero, zero, dot(d, net) / dot(d, product(&inertia, d))]
            }
            Support::Free | Support::Point(_) => {
                let w = triple(c.angular_velocity.into());
                let net = minus(about, cross(w, product(&inertia, w)));
                product(&inverse(&inertia), net)
            }
        };
        [linear, angular]
    }

    /// `J_G + m (c^2 1 - c c)`
    fn inertia_about(&self, mass: Traced, c: Triple) -> Matrix {
        let square = dot(c, c);
        [0, 1, 2].map(|i| {
            [0, 1, 2].map(|j| {
                let own = Traced::from(self.inertia[i][j]);
                let outer = c[i] * c[j];
                let moved = if i == j {
                    square - outer
                } else {
                    Traced::from(0.0) - outer
                };
                own + mass * moved
            })
        })
    }
}
