//! Kinds of motion, and the coordinates that each of them has.

/// Which coordinates a body has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Motion {
    Planar,
    PlanarTranslation,
    Spatial,
    Translation,
    Rotation,
    Pivot,
    FixedPoint,
    FixedAxis,
    Rod,
}

impl Motion {
    pub const ALL: [(&'static str, Self); 9] = [
        ("planar", Self::Planar),
        ("planar_translation", Self::PlanarTranslation),
        ("spatial", Self::Spatial),
        ("translation", Self::Translation),
        ("rotation", Self::Rotation),
        ("pivot", Self::Pivot),
        ("fixed_point", Self::FixedPoint),
        ("fixed_axis", Self::FixedAxis),
        ("rod", Self::Rod),
    ];

    pub fn word(self) -> &'static str {
        Self::ALL
            .iter()
            .find(|(_, motion)| *motion == self)
            .map_or("", |(word, _)| word)
    }

    /// Vectors have two components and moments are scalars.
    pub fn is_planar(self) -> bool {
        matches!(self, Self::Planar | Self::PlanarTranslation | Self::Pivot)
    }

    /// Where G is, is known.
    pub fn knows_position(self) -> bool {
        self != Self::Rotation
    }

    /// G has coordinates of its own.
    pub fn translates(self) -> bool {
        matches!(
            self,
            Self::Planar | Self::PlanarTranslation | Self::Spatial | Self::Translation | Self::Rod
        )
    }

    /// A point of the body is held.
    pub fn is_supported(self) -> bool {
        matches!(self, Self::Pivot | Self::FixedPoint | Self::FixedAxis)
    }

    /// The body turns about one axis, by an angle.
    pub fn is_hinged(self) -> bool {
        matches!(self, Self::Pivot | Self::FixedAxis)
    }

    /// The body turns.
    pub fn has_attitude(self) -> bool {
        !matches!(self, Self::PlanarTranslation | Self::Translation)
    }

    /// The inertia is one moment: about the normal of the plane, or about every axis across a rod.
    pub fn has_one_moment(self) -> bool {
        self.is_planar() || self == Self::Rod
    }

    /// Number of components of a vector.
    pub fn axes(self) -> usize {
        if self.is_planar() { 2 } else { 3 }
    }
}
