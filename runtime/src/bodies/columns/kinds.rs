//! Numbers, vectors, states and accelerations as columns.

use core::fmt;

use nalgebra::{Unit, Vector2, Vector3, Vector4};

use super::column::{Columns, Sink, Source};
use super::names::{Named, Names};
use super::shown::show;
use crate::numbers::scalar::Scalar;
use crate::state::generic;

impl<T: Scalar> Columns<T> for () {
    const COUNT: usize = 0;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn read(_: &mut impl Source<T>) -> Self {}

    #[cfg_attr(not(unoptimized), inline(always))]
    fn write(&self, _: &mut impl Sink<T>) {}
}

impl Named for () {
    const NAMES: Names = Names::Parts(&[]);
}

impl<T: Scalar> Named for T {
    const NAMES: Names = Names::Number("");
}

impl<T: Scalar> Columns<T> for T {
    const COUNT: usize = 1;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn read(source: &mut impl Source<T>) -> Self {
        source.take()
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn write(&self, sink: &mut impl Sink<T>) {
        sink.put(*self);
    }
}

/// Vectors by their components.
macro_rules! vectors {
    ($($vector:ident [$($component:literal)*] $count:literal)*) => {$(
        impl<T: Scalar> Named for $vector<T> {
            const NAMES: Names = Names::Vector(&[$($component),*], "");
        }

        impl<T: Scalar> Columns<T> for $vector<T> {
            const COUNT: usize = $count;

            #[cfg_attr(not(unoptimized), inline(always))]
            fn read(source: &mut impl Source<T>) -> Self {
                let components: [T; $count] = core::array::from_fn(|_| source.take());
                components.into()
            }

            #[cfg_attr(not(unoptimized), inline(always))]
            fn write(&self, sink: &mut impl Sink<T>) {
                for component in self {
                    sink.put(*component);
                }
            }
        }
    )*};
}

vectors! {
    Vector2 ["x" "y"] 2
    Vector3 ["x" "y" "z"] 3
    Vector4 ["x" "y" "z" "w"] 4
}

/// Structs by their fields, with their units; an attitude by the components x, y, z, w of its
/// quaternion.
macro_rules! structs {
    ($($name:ident { $($field:ident: $kind:ident $unit:literal),* })*) => {$(
        impl<T: Scalar> Named for generic::$name<T> {
            const NAMES: Names = Names::Parts(&[
                $((stringify!($field), <$kind<T> as Named>::NAMES.in_unit($unit))),*
            ]);
        }

        /// Its parts with their names and units.
        impl<T: Scalar> fmt::Display for generic::$name<T> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                show(self, f)
            }
        }

        impl<T: Scalar> Columns<T> for generic::$name<T> {
            const COUNT: usize = 0 $(+ <$kind<T> as Columns<T>>::COUNT)*;

            #[cfg_attr(not(unoptimized), inline(always))]
            fn read(source: &mut impl Source<T>) -> Self {
                Self { $($field: Columns::read(source)),* }
            }

            #[cfg_attr(not(unoptimized), inline(always))]
            fn write(&self, sink: &mut impl Sink<T>) {
                $(self.$field.write(sink);)*
            }
        }
    )*};
}

/// A scalar, where a name with a parameter is needed.
type Real<T> = T;
type Attitude<T> = nalgebra::UnitQuaternion<T>;
type Axis<T> = nalgebra::UnitVector3<T>;

structs! {
    Spatial {
        position: Vector3 "m",
        attitude: Attitude "",
        velocity: Vector3 "m/s",
        angular_velocity: Vector3 "rad/s"
    }
    SpatialAcceleration { linear: Vector3 "m/s²", angular: Vector3 "rad/s²" }
    Rotation { attitude: Attitude "", angular_velocity: Vector3 "rad/s" }
    Translation { position: Vector3 "m", velocity: Vector3 "m/s" }
    Planar {
        position: Vector2 "m",
        angle: Real "rad",
        velocity: Vector2 "m/s",
        angular_velocity: Real "rad/s"
    }
    PlanarAcceleration { linear: Vector2 "m/s²", angular: Real "rad/s²" }
    PlanarTranslation { position: Vector2 "m", velocity: Vector2 "m/s" }
    Hinge { angle: Real "rad", angular_velocity: Real "rad/s" }
    Slide { position: Real "m", velocity: Real "m/s" }
    Cylinder {
        position: Real "m",
        angle: Real "rad",
        velocity: Real "m/s",
        angular_velocity: Real "rad/s"
    }
    CylinderAcceleration { linear: Real "m/s²", angular: Real "rad/s²" }
    Universal {
        angle_1: Real "rad",
        angle_2: Real "rad",
        angular_velocity_1: Real "rad/s",
        angular_velocity_2: Real "rad/s"
    }
    Rod { position: Vector3 "m", velocity: Vector3 "m/s", axis: Axis "", axis_rate: Vector3 "1/s" }
    RodAcceleration { linear: Vector3 "m/s²", axis: Vector3 "1/s²" }
}

impl<T: Scalar> Named for Attitude<T> {
    const NAMES: Names = <Vector4<T> as Named>::NAMES;
}

impl<T: Scalar> Named for Axis<T> {
    const NAMES: Names = <Vector3<T> as Named>::NAMES;
}

/// Taken as it is, unit or not.
impl<T: Scalar> Columns<T> for Attitude<T> {
    const COUNT: usize = 4;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn read(source: &mut impl Source<T>) -> Self {
        let coords = Vector4::read(source);
        Unit::new_unchecked(nalgebra::Quaternion { coords })
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn write(&self, sink: &mut impl Sink<T>) {
        self.as_ref().coords.write(sink);
    }
}

/// Taken as it is, unit or not.
impl<T: Scalar> Columns<T> for Axis<T> {
    const COUNT: usize = 3;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn read(source: &mut impl Source<T>) -> Self {
        Unit::new_unchecked(Vector3::read(source))
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn write(&self, sink: &mut impl Sink<T>) {
        self.as_ref().write(sink);
    }
}
