//! The description of a body, as data.

use super::expression::{Axes, Place, Scalar, Vector};
use super::literal::Literal;

#[derive(Clone, Debug)]
pub struct Body {
    pub name: String,
    pub motion: Motion,
    pub params: Vec<Param>,
    pub inputs: Vec<Input>,
    /// States of one's own, by their rates.
    pub rates: Vec<Scalar>,
    /// Whether it has constants and functions of Rust, states of its own and tables.
    pub is_rich: bool,
    /// Whether mass and inertia change.
    pub changes: bool,
    /// Whether loads follow accelerations.
    pub follows: bool,
    /// Absent beside `compose`, and where G does not move.
    pub mass: Option<Scalar>,
    pub inertia: Option<Inertia>,
    pub points: Vec<Point>,
    pub pole: Place,
    pub locals: Vec<Local>,
    pub constraints: Vec<Constraint>,
    pub loads: Vec<Load>,
}

#[derive(Clone, Debug)]
pub enum Motion {
    Spatial,
    Rotation,
    Translation,
    Planar,
    PlanarTranslation,
    Pivot(Support),
    FixedPoint(Support),
    FixedAxis(Support, Axes, [Scalar; 3]),
    Rod([Scalar; 3]),
}

/// The point of the body that is held, and where.
#[derive(Clone, Debug)]
pub struct Support {
    pub point: usize,
    pub anchor: Option<[Scalar; 3]>,
}

/// A parameter with its default.
#[derive(Clone, Debug)]
pub enum Param {
    Scalar(Literal),
    Vector(Axes, [Literal; 3]),
}

#[derive(Clone, Copy, Debug)]
pub enum Input {
    Scalar,
    Vector(Axes),
}

#[derive(Clone, Debug)]
pub struct Point {
    pub axes: Axes,
    pub coordinates: [Scalar; 3],
}

#[derive(Clone, Debug)]
pub enum Local {
    Scalar(Scalar),
    Vector(Vector),
}

/// What is kept at zero, and whether it is of velocities.
#[derive(Clone, Debug)]
pub enum Constraint {
    Scalar(Scalar, bool),
    Vector(Vector, bool),
}

#[derive(Clone, Debug)]
pub enum Inertia {
    /// In the plane and of rods.
    Scalar(Scalar),
    Principal([Scalar; 3]),
    /// xx, yy, zz, xy, yz, zx
    Tensor([Scalar; 6]),
    Products([Scalar; 6]),
    Solid(Solid, Vec<Scalar>),
    Along(Box<Inertia>, [Scalar; 3]),
    Turned(Box<Inertia>, [Scalar; 3], Scalar),
    About(Box<Inertia>, Place),
    Compose(Vec<Part>),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solid {
    Cuboid,
    Ellipsoid,
    Sphere,
    Shell,
    Cylinder,
    Tube,
    Cone,
    Torus,
    Disc,
    Rod,
}

#[derive(Clone, Debug)]
pub struct Part {
    /// Absent of a point mass.
    pub inertia: Option<Inertia>,
    pub mass: Scalar,
    pub at: Place,
}

#[derive(Clone, Debug)]
pub struct Load {
    pub key: Key,
    pub what: What,
}

/// The list that a load stands in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Key {
    Forces,
    Moments,
    JointForces,
    JointMoments,
    Fields,
    Reactions,
    Potentials,
}

#[derive(Clone, Debug)]
pub enum What {
    Force(Vector, Place),
    Moment(Vector),
    PlaneMoment(Scalar),
    /// A uniform field on charges.
    Charges(Vector, Vec<(Scalar, Place)>),
    Potential(Potential),
    /// What is `None` is unknown.
    OpenForce(Axes, [Option<Scalar>; 3], Place),
    OpenMoment(Axes, [Option<Scalar>; 3]),
    /// An unknown force along a direction.
    OpenAlong(Vector, Place),
}

/// Energies whose forces are known by name.
#[derive(Clone, Debug)]
pub enum Potential {
    /// `k / 2 * (length - rest).powi(2)` between a point of the body and one of space.
    Spring {
        stiffness: Scalar,
        rest: Option<Scalar>,
        from: Place,
        to: Place,
    },
    /// `k / distance`
    Central {
        strength: Scalar,
        from: Place,
        to: Place,
    },
    /// `k * bump(distance)`, whose force and its change need two derivatives of `bump`.
    Well {
        strength: Scalar,
        from: Place,
        to: Place,
    },
    /// `-force . P.position()`
    Uniform { force: [Scalar; 3], at: Place },
    /// `-(body vector) . (world vector)`
    Dipole {
        moment: [Scalar; 3],
        field: [Scalar; 3],
    },
    /// `k / 2 * attitude.powi(2)`, in the plane.
    Coil { stiffness: Scalar },
    /// Several of them in one energy.
    Sum(Vec<Potential>),
}

impl Motion {
    pub fn is_planar(&self) -> bool {
        matches!(
            self,
            Self::Planar | Self::PlanarTranslation | Self::Pivot(_)
        )
    }

    pub fn turns(&self) -> bool {
        !matches!(self, Self::Translation | Self::PlanarTranslation)
    }

    /// Whether the motion of G is modeled.
    pub fn moves(&self) -> bool {
        !matches!(self, Self::Rotation)
    }

    pub fn support(&self) -> Option<&Support> {
        match self {
            Self::Pivot(support) | Self::FixedPoint(support) | Self::FixedAxis(support, ..) => {
                Some(support)
            }
            _ => None,
        }
    }
}

impl Load {
    /// Whether some of it is to be solved for.
    pub fn is_open(&self) -> bool {
        matches!(
            self.what,
            What::OpenForce(..) | What::OpenMoment(..) | What::OpenAlong(..)
        )
    }
}

impl Body {
    /// How many numbers an acceleration is.
    pub fn freedoms(&self) -> usize {
        match self.motion {
            Motion::Spatial | Motion::Rod(_) => 6,
            Motion::Rotation | Motion::FixedPoint(_) | Motion::Translation | Motion::Planar => 3,
            Motion::PlanarTranslation => 2,
            Motion::Pivot(_) | Motion::FixedAxis(..) => 1,
        }
    }

    /// How many rows of forces, and of moments, a regressor has.
    pub fn regressor_rows(&self) -> (usize, usize) {
        match self.motion {
            Motion::Spatial | Motion::Rod(_) => (3, 3),
            Motion::Rotation | Motion::FixedPoint(_) => (0, 3),
            Motion::Translation => (3, 0),
            Motion::Planar => (2, 1),
            Motion::PlanarTranslation => (2, 0),
            Motion::Pivot(_) | Motion::FixedAxis(..) => (0, 1),
        }
    }

    /// How many numbers a vector is.
    pub fn axes(&self) -> usize {
        if self.motion.is_planar() { 2 } else { 3 }
    }

    /// Where the numbers of each input begin, and their count.
    pub fn input_offsets(&self) -> (Vec<usize>, usize) {
        offsets(self.inputs.iter().map(|input| match input {
            Input::Scalar => 1,
            Input::Vector(_) => self.axes(),
        }))
    }

    /// Where the numbers of each parameter begin, and their count.
    pub fn param_offsets(&self) -> (Vec<usize>, usize) {
        offsets(self.params.iter().map(|param| match param {
            Param::Scalar(_) => 1,
            Param::Vector(..) => self.axes(),
        }))
    }

    /// The defaults of all parameters, one number after another.
    pub fn defaults(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        for param in &self.params {
            match param {
                Param::Scalar(literal) => numbers.push(literal.nearest()),
                Param::Vector(_, literals) => {
                    numbers.extend(literals.iter().take(self.axes()).map(Literal::nearest));
                }
            }
        }
        numbers
    }
}

fn offsets(counts: impl Iterator<Item = usize>) -> (Vec<usize>, usize) {
    let mut next = 0;
    let offsets = counts
        .map(|count| {
            next += count;
            next - count
        })
        .collect();
    (offsets, next)
}
