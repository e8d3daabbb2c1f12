//! Structs of declared quantities: parameters and inputs.

/// Gives the fields of a struct names and units, and serialization with the feature `serde`. A field
/// with a default may be missing where fields are read by name.
///
/// ```
/// use newton_euler::{columns::Named, prelude::*};
///
/// rigid_body!(Rope {
///     motion: translation,
///     params: [length = 3[m], stretch = 0.1],
///     inputs: [pull = world(_, _, _)[N]],
///     mass: 0.2[kg / m] * length,
///     forces: [pull = pull * stretch],
/// });
///
/// assert_eq!(RopeParams::NAMES.to_string(), "length,stretch");
/// assert_eq!(RopeInput::NAMES.to_string(), "pull.x,pull.y,pull.z");
/// ```
#[doc(hidden)]
#[macro_export]
macro_rules! __record {
    ($name:ident $(<$generic:ident>)? { $($unit:literal $field:ident: $kind:ty $(= $default:expr)?),+ $(,)? }) => {
        impl<$($generic: $crate::private::Scalar)?> $crate::private::Named for $name<$($generic)?> {
            const NAMES: $crate::private::Names = $crate::private::Names::Parts(&[$((
                ::core::stringify!($field),
                <$kind as $crate::private::Named>::NAMES.in_unit($unit),
            )),+]);
        }

        $crate::private::written! { [$($generic)?] $name $($field $kind $(= $default)?,)+ }
    };
}
