//! Reasons why no steady motion was found.

use core::fmt;

use crate::numbers::messages::{Brief, debug_as_display};

/// The number of worst entries that are kept, so that the error stays small.
pub const FEW: usize = 3;

/// The residual of an equation of a steady motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Off {
    /// The coordinate that accelerates, by its name in
    /// [`Linearized::STATES`](crate::linearization::Linearized::STATES); or the violated condition or
    /// constraint.
    pub name: &'static str,
    /// Its rate, or the size of the violation, SI units.
    pub by: f64,
}

/// A free quantity, and where the search left it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Its name in [`Linearized::STATES`](crate::linearization::Linearized::STATES) or
    /// [`Linearized::INPUTS`](crate::linearization::Linearized::INPUTS).
    pub name: &'static str,
    /// Its value, SI units; zero for an attitude.
    pub value: f64,
}

/// Why no steady motion was found.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum TrimError {
    /// No coordinate and no input has this name.
    Unknown {
        /// The name.
        name: &'static str,
    },
    /// A steady turn of a system without a freely moving body: nothing could turn.
    NothingTurns,
    /// A steady turn of a motion in the plane, about an axis that is not along z.
    OutOfPlane,
    /// More constraints and conditions than twice the coordinates of the state.
    TooMany,
    /// A number of the start, or the acceleration there, is infinite or NaN.
    NotFinite {
        /// What has no value, if it is known: a coordinate or an input, by its name in
        /// [`Linearized::STATES`](crate::linearization::Linearized::STATES) or
        /// [`Linearized::INPUTS`](crate::linearization::Linearized::INPUTS), `turning`, `time`, or a
        /// load, a condition or a constraint there.
        name: Option<&'static str>,
    },
    /// The free quantities cannot make the motion steady: there are more equations than unknowns,
    /// or the equations are inconsistent.
    Unbalanced {
        /// The residual, the worst first.
        residual: [Option<Off>; FEW],
        /// Held inputs that would make the motion steady if they were free. If there are none, held
        /// quantities that would reduce the residual to first order, the most effective first; none
        /// if nothing does.
        held: [Option<&'static str>; FEW],
    },
    /// Free quantities without effect where the search ended, to first order, although they have
    /// one elsewhere: a rotor that stands, if the thrust is proportional to the square of its speed.
    /// Newton's method cannot tell which way to change them: try another start.
    NoEffect {
        /// The residual, the worst first.
        residual: [Option<Off>; FEW],
        /// The quantities, two at most.
        free: [Option<Quantity>; 2],
    },
    /// The steps lead to where an acceleration has no value, because a mass or a distance that it
    /// is divided by vanishes.
    Singular {
        /// The coordinate whose acceleration that is, or the condition.
        name: &'static str,
        /// The free quantity with which it changes without bound.
        free: Quantity,
    },
    /// User-defined states that change whatever the inputs are, although everything else can be
    /// steady: fuel that burns, or a battery that is drained. Make them
    /// [`changing`](super::Search::changing).
    Drifting {
        /// The residual, the worst first.
        residual: [Option<Off>; FEW],
        /// The states.
        states: [Option<&'static str>; FEW],
    },
    /// The free quantities could reduce the residual further, but the steps did not converge: try a
    /// start closer to the solution.
    NotConverged {
        /// The residual, the worst first.
        residual: [Option<Off>; FEW],
    },
}

impl fmt::Display for TrimError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { name } => write!(
                f,
                "no coordinate and no input is called `{name}`: the names are those of `STATES` and `INPUTS` of the linearization"
            ),
            Self::OutOfPlane => f.write_str(
                "a motion in the plane turns about z: write `.turning([0.0, 0.0, rate])`",
            ),
            Self::NothingTurns => f.write_str(
                "no body moves freely, so that nothing turns with the world: give the rates of joints in the state",
            ),
            Self::TooMany => f.write_str("there are more constraints and conditions than can be met"),
            Self::NotFinite { name } => {
                f.write_str("the start, or the acceleration there, is not finite")?;
                name.map_or(Ok(()), |name| write!(f, ": `{name}`"))
            }
            Self::Unbalanced { residual, held } => {
                f.write_str("not steady")?;
                left_over(f, residual)?;
                let several = if held[1].is_some() { " some of" } else { "" };
                for (number, name) in held.iter().flatten().enumerate() {
                    match number {
                        0 => write!(f, "; free also{several} `{name}`")?,
                        _ => write!(f, ", `{name}`")?,
                    }
                }
                if held[0].is_none() {
                    f.write_str("; nothing that is free or held reduces that, to first order")?;
                }
                Ok(())
            }
            Self::NoEffect { residual, free } => {
                f.write_str("not steady")?;
                left_over(f, residual)?;
                for (number, Quantity { name, value }) in free.iter().flatten().enumerate() {
                    let before = if number == 0 { "; " } else { ", " };
                    write!(f, "{before}`{name}` has no effect at {}", Brief(*value))?;
                }
                let several = free[1].is_some();
                f.write_str(if several {
                    ": start from other values"
                } else {
                    ": start from another value"
                })
            }
            Self::Singular { name, free } => write!(
                f,
                "the search leads to where `{name}` changes without bound with `{}`, near {}: start from another value, or hold it",
                free.name,
                Brief(free.value)
            ),
            Self::Drifting { residual, states } => {
                f.write_str("not steady")?;
                left_over(f, residual)?;
                f.write_str("; whatever the inputs, states change: add `.changing([")?;
                for (number, name) in states.iter().flatten().enumerate() {
                    let before = if number == 0 { "" } else { ", " };
                    write!(f, "{before}{name:?}")?;
                }
                f.write_str("])`")
            }
            Self::NotConverged { residual } => {
                f.write_str("no steady motion was found from this start")?;
                left_over(f, residual)
            }
        }
    }
}

fn left_over(f: &mut fmt::Formatter<'_>, residual: &[Option<Off>]) -> fmt::Result {
    for (number, off) in residual.iter().flatten().enumerate() {
        let before = if number == 0 { ":" } else { "," };
        write!(f, "{before} `{}` is off by {}", off.name, Brief(off.by))?;
    }
    if residual[0].is_some() {
        f.write_str(" (SI units)")?;
    }
    Ok(())
}

debug_as_display!(TrimError);

impl core::error::Error for TrimError {}
