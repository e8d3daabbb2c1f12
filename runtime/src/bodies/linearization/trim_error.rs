//! Why there is no steady motion.

use core::fmt;

/// How many of the worst are told: an error is small.
pub const FEW: usize = 3;

/// What is left over of an equation of a steady motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Off {
    /// The coordinate that accelerates, by its name in
    /// [`Linearized::STATES`](super::Linearized::STATES); or the condition or the constraint that is
    /// not met.
    pub name: &'static str,
    /// Its rate, or by how much it is not met, SI units.
    pub by: f64,
}

/// Why no steady motion was found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TrimError {
    /// No coordinate and no input is called this.
    Unknown {
        /// The name.
        name: &'static str,
    },
    /// A steady turn of what has no body that moves freely: nothing would be turned.
    NothingTurns,
    /// More constraints and conditions than twice the coordinates of the state.
    TooMany,
    /// The acceleration is not a number at the start.
    NotFinite {
        /// A load that has no value there, if it is known.
        load: Option<&'static str>,
    },
    /// What is free cannot make it steady: the equations are more than the unknowns, or they ask for
    /// what cannot be.
    Unbalanced {
        /// What is left over, the worst first.
        residual: [Option<Off>; FEW],
        /// What would make it less if it were free, the most effective first; none if nothing does.
        held: [Option<&'static str>; FEW],
    },
    /// What is free could bring it nearer, but the steps did not come to an end: a start that is
    /// nearer may help.
    NotConverged {
        /// What is left over, the worst first.
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
            Self::NothingTurns => f.write_str(
                "no body moves freely, so that nothing turns with the world: give the rates of joints in the state",
            ),
            Self::TooMany => f.write_str("there are more constraints and conditions than can be met"),
            Self::NotFinite { load } => {
                f.write_str("the acceleration is not a number at the start")?;
                load.map_or(Ok(()), |load| write!(f, ": `{load}`"))
            }
            Self::Unbalanced { residual, held } => {
                f.write_str("not steady")?;
                left_over(f, residual)?;
                for (number, name) in held.iter().flatten().enumerate() {
                    let before = if number == 0 { "; free also one of" } else { "," };
                    write!(f, "{before} `{name}`")?;
                }
                if held[0].is_none() {
                    f.write_str("; to first order, nothing changes that")?;
                }
                Ok(())
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
        write!(f, "{before} `{}` is off by {:e}", off.name, off.by)?;
    }
    Ok(())
}

impl core::error::Error for TrimError {}
