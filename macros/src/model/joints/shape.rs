//! The states of joints: their coordinates, and the runtime's fields for them.

use crate::model::words::{Meaning, Variable};
use crate::symbolic::Id;

/// The state of a joint, in the runtime's types.
#[derive(Debug)]
pub struct Shape {
    /// The runtime's type.
    pub state: &'static str,
    /// The runtime's type of its acceleration; `None` for a scalar or a vector.
    pub acceleration: Option<&'static str>,
    pub fields: &'static [Field],
    /// The fields of the acceleration.
    pub second: &'static [Field],
}

/// A scalar or a vector of a state: its place, and the names of its components.
#[derive(Debug)]
pub struct Field {
    /// The path from the state to it; empty if it is the whole state.
    pub path: &'static str,
    pub names: &'static [&'static str],
    pub variable: Variable,
    /// The index of its first component.
    pub first: usize,
}

const fn scalar(path: &'static str, name: &'static [&'static str; 1], variable: Variable) -> Field {
    part(path, name, variable, 0)
}

const fn part(
    path: &'static str,
    names: &'static [&'static str],
    variable: Variable,
    first: usize,
) -> Field {
    Field {
        path,
        names,
        variable,
        first,
    }
}

pub const HINGE: Shape = Shape {
    state: "Hinge",
    acceleration: None,
    fields: &[
        scalar("angle", &["angle"], Variable::Angle),
        scalar("angular_velocity", &["w"], Variable::AngularVelocity),
    ],
    second: &[scalar("", &["alpha"], Variable::AngularAcceleration)],
};
pub const SLIDE: Shape = Shape {
    state: "Slide",
    acceleration: None,
    fields: &[
        scalar("position", &["position"], Variable::Position),
        scalar("velocity", &["v"], Variable::Velocity),
    ],
    second: &[scalar("", &["a"], Variable::LinearAcceleration)],
};
pub const CYLINDER: Shape = Shape {
    state: "Cylinder",
    acceleration: Some("CylinderAcceleration"),
    fields: &[
        scalar("position", &["position"], Variable::Position),
        scalar("angle", &["angle"], Variable::Angle),
        scalar("velocity", &["v"], Variable::Velocity),
        scalar("angular_velocity", &["w"], Variable::AngularVelocity),
    ],
    second: &[
        scalar("linear", &["a"], Variable::LinearAcceleration),
        scalar("angular", &["alpha"], Variable::AngularAcceleration),
    ],
};
pub const UNIVERSAL: Shape = Shape {
    state: "Universal",
    acceleration: None,
    fields: &[
        part("angle_1", &["angle_1"], Variable::Angle, 0),
        part("angle_2", &["angle_2"], Variable::Angle, 1),
        part("angular_velocity_1", &["w_1"], Variable::AngularVelocity, 0),
        part("angular_velocity_2", &["w_2"], Variable::AngularVelocity, 1),
    ],
    second: &[part(
        "",
        &["alpha_1", "alpha_2"],
        Variable::AngularAcceleration,
        0,
    )],
};
const ATTITUDE: Field = part(
    "attitude.coords",
    &["qx", "qy", "qz", "qw"],
    Variable::Quaternion,
    0,
);
const TURNING: Field = part(
    "angular_velocity",
    &["wx", "wy", "wz"],
    Variable::AngularVelocity,
    0,
);
const ALPHA: &[&str] = &["alpha_x", "alpha_y", "alpha_z"];
pub const BALL: Shape = Shape {
    state: "Rotation",
    acceleration: None,
    fields: &[ATTITUDE, TURNING],
    second: &[part("", ALPHA, Variable::AngularAcceleration, 0)],
};
pub const FREE: Shape = Shape {
    state: "Spatial",
    acceleration: Some("SpatialAcceleration"),
    fields: &[
        part("position", &["x", "y", "z"], Variable::Position, 0),
        ATTITUDE,
        part("velocity", &["vx", "vy", "vz"], Variable::Velocity, 0),
        TURNING,
    ],
    second: &[
        part(
            "linear",
            &["ax", "ay", "az"],
            Variable::LinearAcceleration,
            0,
        ),
        part("angular", ALPHA, Variable::AngularAcceleration, 0),
    ],
};
pub const PLANE: Shape = Shape {
    state: "Planar",
    acceleration: Some("PlanarAcceleration"),
    fields: &[
        part("position", &["x", "y"], Variable::Position, 0),
        scalar("angle", &["angle"], Variable::Angle),
        part("velocity", &["vx", "vy"], Variable::Velocity, 0),
        scalar("angular_velocity", &["w"], Variable::AngularVelocity),
    ],
    second: &[
        part("linear", &["ax", "ay"], Variable::LinearAcceleration, 0),
        scalar("angular", &["alpha"], Variable::AngularAcceleration),
    ],
};
pub const SHIFT: Shape = Shape {
    state: "Translation",
    acceleration: None,
    fields: &[
        part("position", &["x", "y", "z"], Variable::Position, 0),
        part("velocity", &["vx", "vy", "vz"], Variable::Velocity, 0),
    ],
    second: &[part(
        "",
        &["ax", "ay", "az"],
        Variable::LinearAcceleration,
        0,
    )],
};
pub const SHIFT_IN_THE_PLANE: Shape = Shape {
    state: "PlanarTranslation",
    acceleration: None,
    fields: &[
        part("position", &["x", "y"], Variable::Position, 0),
        part("velocity", &["vx", "vy"], Variable::Velocity, 0),
    ],
    second: &[part("", &["ax", "ay"], Variable::LinearAcceleration, 0)],
};
pub const LINE: Shape = Shape {
    state: "Rod",
    acceleration: Some("RodAcceleration"),
    fields: &[
        part("position", &["x", "y", "z"], Variable::Position, 0),
        part("axis", &["ux", "uy", "uz"], Variable::Axis, 0),
        part("velocity", &["vx", "vy", "vz"], Variable::Velocity, 0),
        part("axis_rate", &["rx", "ry", "rz"], Variable::AxisRate, 0),
    ],
    second: &[
        part(
            "linear",
            &["ax", "ay", "az"],
            Variable::LinearAcceleration,
            0,
        ),
        part("axis", &["bx", "by", "bz"], Variable::AxisAcceleration, 0),
    ],
};

/// A user-defined state, which has a rate but no coordinate.
pub const OWN: Shape = Shape {
    state: "Real",
    acceleration: None,
    fields: &[scalar("", &[""], Variable::Own)],
    second: &[scalar("", &["rate"], Variable::Own)],
};

/// A component of the state of a joint.
#[derive(Clone, Copy, Debug)]
pub struct Coordinate {
    pub variable: Variable,
    pub part: usize,
    pub id: Id,
}

/// The components of the state and of the acceleration of a joint.
#[derive(Clone, Default, Debug)]
pub struct Rates(pub Vec<Coordinate>);

impl Rates {
    /// The symbol of a component of a variable.
    pub fn get(&self, variable: Variable, part: usize) -> Option<Id> {
        let mut all = self.0.iter();
        let found = all.find(|one| one.variable == variable && one.part == part);
        found.map(|one| one.id)
    }
}

impl Shape {
    /// All components of the state and of the acceleration.
    pub fn components(&self) -> impl Iterator<Item = (Variable, usize)> {
        let fields = self.fields.iter().chain(self.second);
        fields.flat_map(|field| {
            (0..field.names.len()).map(|part| (field.variable, field.first + part))
        })
    }
}

impl Field {
    /// The index of the component that a symbol stands for, if it is one of this field. A
    /// quaternion stores its scalar part last.
    pub fn component(&self, meaning: Meaning) -> Option<usize> {
        let Meaning::Of(_, variable, part) = meaning else {
            return None;
        };
        if variable != self.variable {
            return None;
        }
        let part = variable.place(part).checked_sub(self.first)?;
        (part < self.names.len()).then_some(part)
    }
}
