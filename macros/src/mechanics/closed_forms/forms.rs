//! The closed forms, and what loads depend on.

use crate::model::{Meaning, Motion, Variable, Workspace};
use crate::symbolic::{Components, Id};

use super::axial_torque::AxialTorque;
use super::free_rotation::Free;
use super::gyrostat::Gyrostat;
use super::lagrange_top::Top;

/// The motion of a body in closed form.
pub struct Flow {
    /// The constant acceleration of G, in world axes; zero if G has no coordinates.
    pub linear: Components,
    pub rotation: Rotation,
}

impl Flow {
    /// The expressions read at the start of a path, except the entries of a tensor.
    pub fn roots(&self) -> Vec<Id> {
        let mut roots = self.linear.to_vec();
        roots.extend(self.rotation.roots());
        roots
    }

    /// The entries of a tensor whose principal axes are found when the body is built.
    pub fn tensor(&self) -> Option<[Id; 6]> {
        match self.rotation {
            Rotation::Free(Free::Tensor(entries)) => Some(entries),
            _ => None,
        }
    }

    /// The kind of motion, in words, line by line.
    pub fn describe(&self, motion: Motion) -> Vec<String> {
        let center = motion.translates().then_some("G moves on a parabola");
        let lines = center.into_iter().chain(self.rotation.describe());
        lines.map(str::to_owned).collect()
    }
}

/// The rotation of a body.
pub enum Rotation {
    /// None.
    None,
    /// In space, without a moment.
    Free(Free),
    /// In space, under a couple.
    Top(Top),
    /// In space, under a constant moment along its axis of symmetry.
    Axial(AxialTorque),
    /// In space, with rotors.
    Gyrostat(Gyrostat),
    /// As a rod, without a moment.
    GreatCircle,
    /// About an axis, with a constant acceleration.
    Uniform(Id),
    /// About an axis: `theta'' = -rate^2 sin(theta - hanging)`
    Pendulum { rate: Id, hanging: Id },
}

impl Rotation {
    pub fn roots(&self) -> Vec<Id> {
        match self {
            Self::None | Self::GreatCircle => Vec::new(),
            Self::Free(free) => free.roots(),
            Self::Top(top) => top.roots(),
            Self::Axial(axial) => axial.roots(),
            Self::Gyrostat(gyrostat) => gyrostat.roots(),
            Self::Uniform(acceleration) => vec![*acceleration],
            Self::Pendulum { rate, hanging } => vec![*rate, *hanging],
        }
    }

    /// The kind of rotation, in words.
    pub fn describe(&self) -> Option<&'static str> {
        Some(match self {
            Self::None => return None,
            Self::Free(Free::Steady) => "the body turns at a constant rate",
            Self::Free(Free::Symmetric(..)) => "the body precesses steadily",
            Self::Free(Free::Principal(..)) => "the body turns by elliptic functions",
            Self::Free(Free::Along(_) | Free::Tensor(_)) => {
                "the body turns freely, in a way that its moments of inertia decide"
            }
            Self::Top(_) => "the body turns as Lagrange's top, by elliptic functions",
            Self::Axial(_) => {
                "the spin about the axis of symmetry is linear in time, the attitude goes by parabolic cylinder functions"
            }
            Self::Gyrostat(gyrostat) if gyrostat.drift == gyrostat.along => {
                "the body precesses steadily, as a gyrostat"
            }
            Self::Gyrostat(_) => {
                "the body turns as a gyrostat, whose momentum along its axis is linear in time, by parabolic cylinder functions"
            }
            Self::GreatCircle => "the axis turns along a great circle",
            Self::Uniform(_) => "the angle is quadratic in time",
            Self::Pendulum { .. } => "the angle is that of a pendulum, by elliptic functions",
        })
    }
}

/// What a load contributes, without its unknown components.
pub struct Contribution {
    pub name: String,
    /// In world axes.
    pub force: Components,
    /// About G or the held point, in body axes; for a rod, in world axes.
    pub moment: Components,
}

/// What expressions depend on. Of several quantities, the one that is least like a constant.
pub fn dependence(work: &Workspace, roots: &[Id]) -> &'static str {
    let graph = &work.graph;
    let causes = graph
        .nodes_of(roots)
        .into_iter()
        .filter_map(|id| cause(work.meaning(id)?));
    causes.min().map_or("the state", |(_, word)| word)
}

/// A rank, and a word, for a quantity that changes in time.
fn cause(meaning: Meaning) -> Option<(u8, &'static str)> {
    use Variable::{Angle, AngularVelocity, Axis, AxisRate, Position, Quaternion, Velocity};
    Some(match meaning {
        Meaning::Input(..) => (0, "an input (make it a parameter if it is held)"),
        Meaning::Time => (1, "the time"),
        Meaning::Of(_, Velocity, _) => (2, "the velocity"),
        Meaning::Of(_, Position, _) => (3, "the position"),
        Meaning::Of(_, AngularVelocity | AxisRate, _) => (4, "the angular velocity"),
        Meaning::Of(_, Quaternion | Axis, _) => (5, "the attitude"),
        Meaning::Of(_, Angle, _) => (6, "the angle"),
        _ => return None,
    })
}
