//! Parameters that no body can have.

use core::fmt;

use crate::mechanics::inertia::InvalidInertia;
use crate::numbers::messages::{Number, debug_as_display};

/// Why a body cannot be built from these parameters.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum InvalidBody {
    /// A parameter is infinite or NaN.
    NotFinite {
        /// Its name in the description.
        name: &'static str,
        /// The given value.
        value: f64,
    },
    /// A value that is computed from parameters is infinite or NaN, as where a parameter in a divisor
    /// is zero.
    Derived {
        /// The names of these parameters in the description, as in "`arm`, `load`"; of many, the first.
        from: &'static str,
        /// The computed value.
        value: f64,
    },
    /// The mass is not a positive finite number.
    Mass {
        /// The given value \[kg\].
        value: f64,
    },
    /// The moment of inertia `J_G` of a planar body or of a rod, or that of a body about its hinge, is
    /// not a positive finite number.
    PlanarInertia {
        /// The given value \[kg m²\].
        value: f64,
    },
    /// The length of a link is not a positive finite number, a property of a cable or the armature of
    /// a joint is negative or not finite, or loads that resist accelerations take away more inertia
    /// than there is.
    Property {
        /// The name of the link, the cable or the joint, or of the body or the joint whose inertia is
        /// taken away.
        of: &'static str,
        /// `length`, `stiffness`, `armature`, `inertia with added mass`, `added mass` or
        /// `armature with its drive`.
        property: &'static str,
        /// The given value \[m, N/m, kg or kg m²\].
        value: f64,
    },
    /// No body that can rotate has this inertia tensor.
    Inertia(InvalidInertia),
    /// A body of a system has an impossible mass or inertia.
    Member {
        /// Its name.
        body: &'static str,
        /// The impossible property.
        impossible: Impossible,
    },
}

/// An impossible mass or inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Impossible {
    /// A mass that is not a positive finite number \[kg\].
    Mass(f64),
    /// A moment of inertia `J_G`, or that about the hinge, that is not a positive finite number
    /// \[kg m²\].
    PlanarInertia(f64),
    /// An inertia tensor.
    Inertia(InvalidInertia),
}

impl InvalidBody {
    /// Whether the error is that a value is NaN.
    pub(crate) fn is_of_no_number(&self) -> bool {
        match self {
            Self::NotFinite { value, .. }
            | Self::Derived { value, .. }
            | Self::Mass { value }
            | Self::PlanarInertia { value }
            | Self::Property { value, .. } => value.is_nan(),
            Self::Inertia(_) => false,
            Self::Member { impossible, .. } => Self::from(*impossible).is_of_no_number(),
        }
    }
}

impl From<Impossible> for InvalidBody {
    fn from(impossible: Impossible) -> Self {
        match impossible {
            Impossible::Mass(value) => Self::Mass { value },
            Impossible::PlanarInertia(value) => Self::PlanarInertia { value },
            Impossible::Inertia(error) => Self::Inertia(error),
        }
    }
}

impl From<InvalidInertia> for InvalidBody {
    fn from(error: InvalidInertia) -> Self {
        Self::Inertia(error)
    }
}

impl fmt::Display for InvalidBody {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { name, value } => {
                write!(f, "`{name}` must be finite, is {}", Number(value))
            }
            Self::Derived { from, value } => write!(
                f,
                "a value computed from {from} must be finite, is {}",
                Number(value)
            ),
            Self::Mass { value } => write!(
                f,
                "mass must be positive and finite, is {} kg",
                Number(value)
            ),
            Self::PlanarInertia { value } => write!(
                f,
                "inertia must be positive and finite, is {} kg m²",
                Number(value)
            ),
            Self::Property {
                of,
                property,
                value,
            } => write!(f, "the {property} of `{of}` cannot be {}", Number(value)),
            Self::Inertia(error) => write!(f, "impossible inertia: {error}"),
            Self::Member { body, impossible } => match impossible {
                Impossible::Mass(value) => write!(
                    f,
                    "the mass of `{body}` must be positive and finite, is {} kg",
                    Number(value)
                ),
                Impossible::PlanarInertia(value) => write!(
                    f,
                    "the inertia of `{body}` must be positive and finite, is {} kg m²",
                    Number(value)
                ),
                Impossible::Inertia(error) => {
                    write!(f, "impossible inertia of `{body}`: {error}")
                }
            },
        }
    }
}

debug_as_display!(InvalidBody);

impl core::error::Error for InvalidBody {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Inertia(error)
            | Self::Member {
                impossible: Impossible::Inertia(error),
                ..
            } => Some(error),
            _ => None,
        }
    }
}
