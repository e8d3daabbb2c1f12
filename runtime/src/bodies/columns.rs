//! Types that hold a fixed number of scalars, read and written as a sequence of scalars.
//!
//! An ensemble stores its members in columns. Reading one number from each column gives one body
//! with its state; reading several at once gives a body over lanes. `rigid_body!` implements these
//! traits for bodies that are generic over their scalar.

use core::fmt::Debug;

use nalgebra::{Unit, Vector2, Vector3, Vector4};

use crate::bodies::body::{InvalidBody, RigidBody};
use crate::numbers::scalar::Scalar;
use crate::state::{Coordinates, generic};

/// A type that consists of scalars only.
pub trait Columns<T: Scalar>: Clone + Debug + Send + Sync {
    /// The number of its scalars.
    const COUNT: usize;

    /// Reads them from a source, in order.
    fn read(source: &mut impl Source<T>) -> Self;

    /// Writes them to a sink, in the same order.
    fn write(&self, sink: &mut impl Sink<T>);
}

/// A sequence of scalars to read.
pub trait Source<T> {
    /// The next scalar.
    fn take(&mut self) -> T;
}

/// A sequence of scalars to write.
pub trait Sink<T> {
    /// Writes the next scalar.
    fn put(&mut self, scalar: T);
}

/// A body over a scalar, all of whose parts are columns.
pub trait Columnar<T: Scalar>:
    RigidBody<
        Scalar = T,
        State: Columns<T> + Coordinates<Acceleration: Columns<T>>,
        Input: Columns<T>,
    > + Columns<T>
{
}

impl<T: Scalar, B: Columns<T>> Columnar<T> for B where
    B: RigidBody<
            Scalar = T,
            State: Columns<T> + Coordinates<Acceleration: Columns<T>>,
            Input: Columns<T>,
        >
{
}

/// A body that is generic over its scalar, at `f64`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no body that is generic over its scalar, at `f64`",
    label = "not generic, or at another scalar",
    note = "describe it as `rigid_body!(Name::<T> {{ .. }})` and use `Name<f64>`"
)]
pub trait Generic: Columnar<f64> {
    /// The same body over another scalar, with the same columns.
    type With<T: Scalar>: Columnar<T>;

    /// Its parameters; `()` if it has none.
    type Params: Columns<f64>;

    /// The same as `new`.
    ///
    /// # Errors
    /// [`InvalidBody`], as for `new`.
    fn build(params: Self::Params) -> Result<Self, InvalidBody>;

    /// The parameters it was built from.
    fn parameters(&self) -> Self::Params;
}

impl<T: Scalar> Columns<T> for () {
    const COUNT: usize = 0;

    #[inline(always)]
    fn read(_: &mut impl Source<T>) -> Self {}

    #[inline(always)]
    fn write(&self, _: &mut impl Sink<T>) {}
}

impl<T: Scalar> Columns<T> for T {
    const COUNT: usize = 1;

    #[inline(always)]
    fn read(source: &mut impl Source<T>) -> Self {
        source.take()
    }

    #[inline(always)]
    fn write(&self, sink: &mut impl Sink<T>) {
        sink.put(*self);
    }
}

/// Vectors by their components.
macro_rules! vectors {
    ($($vector:ident $count:literal)*) => {$(
        impl<T: Scalar> Columns<T> for $vector<T> {
            const COUNT: usize = $count;

            #[inline(always)]
            fn read(source: &mut impl Source<T>) -> Self {
                let components: [T; $count] = core::array::from_fn(|_| source.take());
                components.into()
            }

            #[inline(always)]
            fn write(&self, sink: &mut impl Sink<T>) {
                for component in self {
                    sink.put(*component);
                }
            }
        }
    )*};
}

vectors! { Vector2 2 Vector3 3 Vector4 4 }

/// Structs by their fields; an attitude by the components x, y, z, w of its quaternion.
macro_rules! structs {
    ($($name:ident { $($field:ident: $kind:ident),* })*) => {$(
        impl<T: Scalar> Columns<T> for generic::$name<T> {
            const COUNT: usize = 0 $(+ <$kind<T> as Columns<T>>::COUNT)*;

            #[inline(always)]
            fn read(source: &mut impl Source<T>) -> Self {
                Self { $($field: Columns::read(source)),* }
            }

            #[inline(always)]
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
    Spatial { position: Vector3, attitude: Attitude, velocity: Vector3, angular_velocity: Vector3 }
    SpatialAcceleration { linear: Vector3, angular: Vector3 }
    Rotation { attitude: Attitude, angular_velocity: Vector3 }
    Translation { position: Vector3, velocity: Vector3 }
    Planar { position: Vector2, angle: Real, velocity: Vector2, angular_velocity: Real }
    PlanarAcceleration { linear: Vector2, angular: Real }
    PlanarTranslation { position: Vector2, velocity: Vector2 }
    Hinge { angle: Real, angular_velocity: Real }
    Slide { position: Real, velocity: Real }
    Cylinder { position: Real, angle: Real, velocity: Real, angular_velocity: Real }
    CylinderAcceleration { linear: Real, angular: Real }
    Universal { angle_1: Real, angle_2: Real, angular_velocity_1: Real, angular_velocity_2: Real }
    Rod { position: Vector3, velocity: Vector3, axis: Axis, axis_rate: Vector3 }
    RodAcceleration { linear: Vector3, axis: Vector3 }
}

/// Taken as it is, unit or not.
impl<T: Scalar> Columns<T> for Attitude<T> {
    const COUNT: usize = 4;

    #[inline(always)]
    fn read(source: &mut impl Source<T>) -> Self {
        let coords = Vector4::read(source);
        Unit::new_unchecked(nalgebra::Quaternion { coords })
    }

    #[inline(always)]
    fn write(&self, sink: &mut impl Sink<T>) {
        self.as_ref().coords.write(sink);
    }
}

/// Taken as it is, unit or not.
impl<T: Scalar> Columns<T> for Axis<T> {
    const COUNT: usize = 3;

    #[inline(always)]
    fn read(source: &mut impl Source<T>) -> Self {
        Unit::new_unchecked(Vector3::read(source))
    }

    #[inline(always)]
    fn write(&self, sink: &mut impl Sink<T>) {
        self.as_ref().write(sink);
    }
}
