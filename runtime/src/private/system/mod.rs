//! The state of a system: a struct with the state of each joint; also of a body with user-defined
//! states.

mod parts;
#[cfg(feature = "serde")]
mod serialized;

pub use parts::{
    Parts, PartsMut, any, axes, coordinates, count, freedoms, groups, positions, second_unit,
    shifts,
};
#[cfg(feature = "serde")]
pub use serialized::{Name, fill, finite, found, ignore, next};

/// Defines the state of a system and its acceleration: two structs with a field for each joint, in
/// the order in which they are written.
///
/// ```
/// use newton_euler::prelude::*;
///
/// newton_euler::private::system_state! {
///     /// The state of a double pendulum.
///     DoublePendulumState
///     /// The acceleration of a double pendulum.
///     DoublePendulumAcceleration {
///         /// From the ground to the upper arm.
///         shoulder: Hinge
///             /// From the ground to the upper arm \[rad/s²\].
///             => f64,
///         /// From the upper arm to the lower.
///         elbow: Hinge
///             /// From the upper arm to the lower \[rad/s²\].
///             => f64,
///     }
/// }
///
/// let still = DoublePendulumState::default();
/// let falling = DoublePendulumAcceleration { shoulder: -2.0, elbow: 1.0 };
/// let later = still.moved(&(still.rate(&falling) * 0.5));
/// assert_eq!(later.shoulder.angular_velocity, -1.0);
/// assert_eq!(later.elbow.angular_velocity, 0.5);
/// ```
///
/// A user-defined state is `name: Real "kg" => f64`, a scalar with its unit and its rate.
///
/// A joint is `name: Kind => Acceleration`: the kind is the name of a state of
/// [`state::generic`](crate::state::generic), and the type after the arrow is the acceleration of
/// that state. A system that is generic over its scalar has the name of the scalar in angle
/// brackets before the braces, and in the accelerations:
///
/// ```
/// newton_euler::private::system_state! {
///     SatelliteState
///     SatelliteAcceleration <T> {
///         orbit: Spatial => newton_euler::private::generic::SpatialAcceleration<T>,
///         gimbal: Rotation => newton_euler::nalgebra::Vector3<T>,
///         wheel: Hinge => T,
///     }
/// }
/// ```
///
/// Attributes, including documentation, precede their item: each struct, each field of
/// the state, and before the arrow those of the field of the acceleration. Everything is public.
/// Both structs are `Clone, Copy, Debug, Default, PartialEq`, `Display`,
/// [`Columns`](crate::columns::Columns), [`Named`](crate::columns::Named) and, with the feature `serde`, serialized as structs with named fields. The state is a
/// [`State`](crate::state::State) with [`Coordinates`](crate::state::Coordinates), both of them
/// [`List`](crate::state::List)s: first the coordinates, joint by joint, and then their rates. A
/// displacement has first the velocities of all joints, and then their accelerations.
#[doc(hidden)]
#[macro_export]
macro_rules! __system_state {
    (
        $(#[$on_state:meta])* $state:ident
        $(#[$on_acceleration:meta])* $acceleration:ident {
            $(
                $(#[$on_field:meta])* $field:ident: $kind:ident $($unit:literal)?
                $(#[$on_second:meta])* => $second:ty
            ),+ $(,)?
        }
    ) => {
        $crate::private::system_state! {
            @items [] f64
            [$(#[$on_state])*] $state [$(#[$on_acceleration])*] $acceleration
            $(
                [$(#[$on_field])*] $field [$($unit)?] $kind ($crate::private::$kind)
                [$(#[$on_second])*] ($second)
            )+
        }
    };
    (
        $(#[$on_state:meta])* $state:ident
        $(#[$on_acceleration:meta])* $acceleration:ident <$scalar:ident> {
            $(
                $(#[$on_field:meta])* $field:ident: $kind:ident $($unit:literal)?
                $(#[$on_second:meta])* => $second:ty
            ),+ $(,)?
        }
    ) => {
        $crate::private::system_state! {
            @items [$scalar] $scalar
            [$(#[$on_state])*] $state [$(#[$on_acceleration])*] $acceleration
            $(
                [$(#[$on_field])*] $field [$($unit)?] $kind ($crate::private::generic::$kind<$scalar>)
                [$(#[$on_second])*] ($second)
            )+
        }
    };
    (
        @items [$($generic:ident)?] $scalar:ident
        [$($on_state:tt)*] $state:ident [$($on_acceleration:tt)*] $acceleration:ident
        $(
            [$($on_field:tt)*] $field:ident [$($unit:literal)?] $kind:ident ($first:ty)
            [$($on_second:tt)*] ($second:ty)
        )+
    ) => {
        $($on_state)*
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        #[allow(clippy::struct_field_names)]
        pub struct $state<$($generic: $crate::private::Scalar)?> {
            $($($on_field)* pub $field: $first,)+
        }

        $($on_acceleration)*
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        #[allow(clippy::struct_field_names)]
        pub struct $acceleration<$($generic: $crate::private::Scalar)?> {
            $($($on_second)* pub $field: $second,)+
        }

        // names of these numbers, which rustdoc shows in types
        const _: () = {
            const COORDINATES: usize =
                0 $(+ $crate::private::system::coordinates::<$crate::private::$kind>())+;
            const RATES: usize = 0 $(
                + $crate::private::system::shifts::<$crate::private::$kind>()
                + $crate::private::system::freedoms::<$crate::private::$kind>()
            )+;

            impl<$($generic: $crate::private::Scalar)?> $state<$($generic)?> {
                /// The number of coordinates: positions and velocities.
                pub const COORDINATES: usize = COORDINATES;
                /// The number of rates: those of the positions and of the velocities.
                pub const RATES: usize = RATES;
            }

            #[allow(clippy::inline_always)]
            impl<$($generic: $crate::private::Scalar)?> $crate::private::State
                for $state<$($generic)?>
            {
                type Scalar = $scalar;
                type Acceleration = $acceleration<$($generic)?>;
                type Rate = $crate::private::List<$scalar, RATES>;

                #[inline(always)]
                fn rate(&self, acceleration: &Self::Acceleration) -> Self::Rate {
                    const SHIFTS: usize =
                        0 $(+ $crate::private::system::shifts::<$crate::private::$kind>())+;
                    let [any, ..] = [$($crate::private::system::any(&self.$field)),+];
                    let mut rate = $crate::private::List::repeat(any);
                    let mut parts = $crate::private::system::PartsMut::of(&mut rate, SHIFTS);
                    $(parts.put(
                        $crate::private::State::rate(&self.$field, &acceleration.$field).as_slice(),
                        $crate::private::system::shifts::<$crate::private::$kind>(),
                    );)+
                    rate
                }

                #[inline(always)]
                fn moved(&self, displacement: &Self::Rate) -> Self {
                    const SHIFTS: usize =
                        0 $(+ $crate::private::system::shifts::<$crate::private::$kind>())+;
                    let [any, ..] = [$($crate::private::system::any(&self.$field)),+];
                    let mut parts = $crate::private::system::Parts::of(displacement, SHIFTS, any);
                    Self {
                        $($field: {
                            let part = parts.take::<
                            {
                                $crate::private::system::shifts::<$crate::private::$kind>()
                                    + $crate::private::system::freedoms::<$crate::private::$kind>()
                            },
                        >($crate::private::system::shifts::<$crate::private::$kind>());
                            $crate::private::State::moved(
                                &self.$field,
                                &::core::convert::Into::into(part),
                            )
                        },)+
                    }
                }
            }

            #[allow(clippy::inline_always)]
            impl<$($generic: $crate::private::Scalar)?> $crate::private::Coordinates
                for $state<$($generic)?>
            {
                type Array = $crate::private::List<$scalar, COORDINATES>;

                const GROUPS: &'static [usize] = &{
                    const PARTS: &[&[usize]] = &[
                        $(<$crate::private::$kind as $crate::private::Coordinates>::GROUPS,)+
                    ];
                    const COUNT: usize = $crate::private::system::count(PARTS);
                    $crate::private::system::groups::<COUNT>(PARTS)
                };

                const AXES: ::core::option::Option<[usize; 2]> = $crate::private::system::axes(&[$((
                    <$crate::private::$kind as $crate::private::Coordinates>::GROUPS,
                    <$crate::private::$kind as $crate::private::Coordinates>::AXES,
                ),)+]);

                #[inline(always)]
                fn coordinates(&self) -> Self::Array {
                    let [any, ..] = [$($crate::private::system::any(&self.$field)),+];
                    let mut list = $crate::private::List::repeat(any);
                    let place = const { $crate::private::system::positions::<Self>() };
                    let mut parts = $crate::private::system::PartsMut::of(&mut list, place);
                    $(parts.put(
                        &$crate::private::Coordinates::coordinates(&self.$field),
                        $crate::private::system::positions::<$first>(),
                    );)+
                    list
                }

                #[inline(always)]
                fn from_coordinates(coordinates: &Self::Array) -> Self {
                    let [any, ..] = coordinates.0;
                    let place = const { $crate::private::system::positions::<Self>() };
                    let mut parts = $crate::private::system::Parts::of(coordinates, place, any);
                    Self {
                        $($field: $crate::private::Coordinates::from_coordinates(
                            &parts.take($crate::private::system::positions::<$first>()),
                        ),)+
                    }
                }

                #[inline(always)]
                fn rates(&self, acceleration: &Self::Acceleration) -> Self::Array {
                    let [any, ..] = [$($crate::private::system::any(&self.$field)),+];
                    let mut rates = $crate::private::List::repeat(any);
                    let place = const { $crate::private::system::positions::<Self>() };
                    let mut parts = $crate::private::system::PartsMut::of(&mut rates, place);
                    $(parts.put(
                        &$crate::private::Coordinates::rates(&self.$field, &acceleration.$field),
                        $crate::private::system::positions::<$first>(),
                    );)+
                    rates
                }

                #[inline(always)]
                fn keep(coordinates: &Self::Array, change: &mut Self::Array) {
                    let (before, [any, ..]) = (*change, coordinates.0);
                    let place = const { $crate::private::system::positions::<Self>() };
                    let mut starts = $crate::private::system::Parts::of(coordinates, place, any);
                    let mut changes = $crate::private::system::Parts::of(&before, place, any);
                    let mut parts = $crate::private::system::PartsMut::of(change, place);
                    $({
                        let first = const { $crate::private::system::positions::<$first>() };
                        let (start, mut change) = (starts.take(first), changes.take(first));
                        <$first as $crate::private::Coordinates>::keep(&start, &mut change);
                        parts.put(&change, first);
                    })+
                }
            }
        };

        $crate::private::system_state! {
            @columns [$($generic)?] $scalar $state $(
                $field $first,
                <$first as $crate::private::Named>::NAMES $(.in_unit($unit))?;
            )+

        }
        $crate::private::system_state! {
            @columns [$($generic)?] $scalar $acceleration $(
                $field $second,
                <$second as $crate::private::Named>::NAMES
                    .in_unit($crate::private::system::second_unit::<$crate::private::$kind>());
            )+
        }
        $crate::private::written! {
            [$($generic)?] $state ($crate::private::system::finite) $($field $first,)+
        }
        $crate::private::written! { [$($generic)?] $acceleration $($field $second,)+ }
    };
    (
        @columns [$($generic:ident)?] $scalar:ident $name:ident
        $($field:ident $part:ty, $names:expr;)+
    ) => {
        impl<$($generic: $crate::private::Scalar)?> $crate::private::Named for $name<$($generic)?> {
            const NAMES: $crate::private::Names = $crate::private::Names::Parts(&[
                $((::core::stringify!($field), $names)),+
            ]);
        }

        /// Its parts with their names and units.
        impl<$($generic: $crate::private::Scalar)?> ::core::fmt::Display for $name<$($generic)?> {
            fn fmt(
                &self,
                f: &mut ::core::fmt::Formatter<'_>,
            ) -> ::core::fmt::Result {
                $crate::private::show::<$scalar>(self, f)
            }
        }

        #[allow(clippy::inline_always)]
        impl<$($generic: $crate::private::Scalar)?> $crate::private::Columns<$scalar>
            for $name<$($generic)?>
        {
            const COUNT: usize = 0 $(+ <$part as $crate::private::Columns<$scalar>>::COUNT)+;

            #[inline(always)]
            fn read(source: &mut impl $crate::private::Source<$scalar>) -> Self {
                Self { $($field: $crate::private::Columns::read(source),)+ }
            }

            #[inline(always)]
            fn write(&self, sink: &mut impl $crate::private::Sink<$scalar>) {
                $($crate::private::Columns::write(&self.$field, sink);)+
            }
        }
    };
}
