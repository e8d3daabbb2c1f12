//! Serialized states of systems: structs with named fields.

use core::fmt;

use serde::Deserialize;
use serde::de::{
    DeserializeSeed, Deserializer, Error, Expected, IgnoredAny, MapAccess, SeqAccess, Visitor,
};

use crate::state::{Coordinates, check};

/// The next element of a sequence, of which this many were read.
///
/// # Errors
/// It is missing, or it is refused.
pub fn next<'de, T: Deserialize<'de>, A: SeqAccess<'de>>(
    elements: &mut A,
    place: &mut usize,
    expected: &dyn Expected,
) -> Result<T, A::Error> {
    let element = elements.next_element()?;
    let element = element.ok_or_else(|| Error::invalid_length(*place, expected))?;
    *place += 1;
    Ok(element)
}

/// The next value of a map as the field of this name, which must not occur twice.
///
/// # Errors
/// It occurs twice, or it is refused.
pub fn fill<'de, T: Deserialize<'de>, A: MapAccess<'de>>(
    field: &mut Option<T>,
    name: &'static str,
    values: &mut A,
) -> Result<(), A::Error> {
    if field.is_some() {
        return Err(Error::duplicate_field(name));
    }
    *field = Some(values.next_value()?);
    Ok(())
}

/// Skips the next value of a map.
///
/// # Errors
/// It cannot be read.
pub fn ignore<'de, A: MapAccess<'de>>(values: &mut A) -> Result<(), A::Error> {
    values.next_value::<IgnoredAny>().map(|_| ())
}

/// The value of a required field.
///
/// # Errors
/// It is missing.
pub fn found<T, E: Error>(field: Option<T>, name: &'static str) -> Result<T, E> {
    field.ok_or_else(|| Error::missing_field(name))
}

/// Refuses a state that is not finite.
///
/// # Errors
/// It is not finite.
pub fn finite<S: Coordinates, E: Error>(state: &S) -> Result<(), E> {
    check(state.coordinates().as_ref()).map_err(E::custom)
}

/// The name of a field on reading, if it is one of these. Other names are refused if fields may be
/// missing, because a misspelt field would then count as missing.
#[derive(Clone, Copy, Debug)]
pub struct Name {
    pub names: &'static [&'static str],
    pub may_be_missing: bool,
}

impl<'de> DeserializeSeed<'de> for Name {
    type Value = Option<&'static str>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Name {
    type Value = Option<&'static str>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a field")
    }

    fn visit_u64<E: Error>(self, place: u64) -> Result<Self::Value, E> {
        let place = usize::try_from(place).ok();
        Ok(place.and_then(|place| self.names.get(place)).copied())
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<Self::Value, E> {
        let found = self.names.iter().copied().find(|other| *other == name);
        if found.is_none() && self.may_be_missing {
            return Err(Error::unknown_field(name, self.names));
        }
        Ok(found)
    }

    fn visit_bytes<E: Error>(self, name: &[u8]) -> Result<Self::Value, E> {
        let name = core::str::from_utf8(name).map_err(Error::custom)?;
        self.visit_str(name)
    }
}

/// Serializes and reads a struct with these fields. Each field refuses its invalid values; a check
/// after the name, if there is one, refuses invalid combinations. A field with a default may be
/// missing where fields are read by name.
#[doc(hidden)]
#[macro_export]
macro_rules! __written {
    ([$($generic:ident)?] $name:ident $(($check:path))? $($field:ident $part:ty $(= $default:expr)?,)+) => {
        impl<$($generic: $crate::private::Scalar + $crate::private::serde::Serialize)?>
            $crate::private::serde::Serialize for $name<$($generic)?>
        {
            fn serialize<SystemSerializer: $crate::private::serde::Serializer>(
                &self,
                serializer: SystemSerializer,
            ) -> ::core::result::Result<SystemSerializer::Ok, SystemSerializer::Error> {
                let mut written = $crate::private::serde::Serializer::serialize_struct(
                    serializer,
                    const { $crate::private::bare(::core::stringify!($name)) },
                    [$(::core::stringify!($field)),+].len(),
                )?;
                $($crate::private::serde::ser::SerializeStruct::serialize_field(
                    &mut written,
                    const { $crate::private::bare(::core::stringify!($field)) },
                    &self.$field,
                )?;)+
                $crate::private::serde::ser::SerializeStruct::end(written)
            }
        }

        #[allow(clippy::approx_constant)]
        const _: () = {
            // what has been read
            #[allow(non_snake_case, clippy::struct_field_names)]
            struct SystemVisitor<$($generic: $crate::private::Scalar)?> {
                $($field: ::core::option::Option<$part>,)+
            }

            impl<$($generic: $crate::private::Scalar)?> SystemVisitor<$($generic)?> {
                const NAME: &str =
                    $crate::private::bare(::core::stringify!($name));
                const NAMES: &[&str] =
                    &[$($crate::private::bare(::core::stringify!($field)),)+];
                const DEFAULTS: &[&str] = &[$($(::core::stringify!($default),)?)+];
            }

            impl<
                'de,
                $($generic: $crate::private::Scalar + $crate::private::serde::Deserialize<'de>)?
            > $crate::private::serde::de::Visitor<'de> for SystemVisitor<$($generic)?> {
                type Value = $name<$($generic)?>;

                fn expecting(
                    &self,
                    f: &mut ::core::fmt::Formatter<'_>,
                ) -> ::core::fmt::Result {
                    ::core::write!(f, "struct {}", Self::NAME)
                }

                fn visit_seq<SystemFields: $crate::private::serde::de::SeqAccess<'de>>(
                    self,
                    mut fields: SystemFields,
                ) -> ::core::result::Result<Self::Value, SystemFields::Error> {
                    let mut place = 0;
                    let read = $name {
                        $($field: $crate::private::system::next(
                            &mut fields,
                            &mut place,
                            &self,
                        )?,)+
                    };
                    $($check(&read)?;)?
                    ::core::result::Result::Ok(read)
                }

                fn visit_map<SystemFields: $crate::private::serde::de::MapAccess<'de>>(
                    mut self,
                    mut fields: SystemFields,
                ) -> ::core::result::Result<Self::Value, SystemFields::Error> {
                    while let ::core::option::Option::Some(found) =
                        $crate::private::serde::de::MapAccess::next_key_seed(
                            &mut fields,
                            $crate::private::system::Name {
                                names: Self::NAMES,
                                may_be_missing: !Self::DEFAULTS.is_empty(),
                            },
                        )?
                    {
                        $(
                            let name = const {
                                $crate::private::bare(::core::stringify!($field))
                            };
                            if found == ::core::option::Option::Some(name) {
                                $crate::private::system::fill(
                                    &mut self.$field,
                                    name,
                                    &mut fields,
                                )?;
                                continue;
                            }
                        )+
                        $crate::private::system::ignore(&mut fields)?;
                    }
                    let read = $name {
                        $($field: $crate::private::system::found(
                            self.$field
                                $(.or(::core::option::Option::Some($default)))?,
                            const {
                                $crate::private::bare(::core::stringify!($field))
                            },
                        )?,)+
                    };
                    $($check(&read)?;)?
                    ::core::result::Result::Ok(read)
                }
            }

            impl<'de, $($generic: $crate::private::Scalar + $crate::private::serde::Deserialize<'de>)?>
                $crate::private::serde::Deserialize<'de> for $name<$($generic)?>
            {
                fn deserialize<SystemDeserializer: $crate::private::serde::Deserializer<'de>>(
                    deserializer: SystemDeserializer,
                ) -> ::core::result::Result<Self, SystemDeserializer::Error> {
                    let nothing: SystemVisitor<$($generic)?> =
                        SystemVisitor { $($field: ::core::option::Option::None,)+ };
                    $crate::private::serde::Deserializer::deserialize_struct(
                        deserializer,
                        SystemVisitor::<$($generic)?>::NAME,
                        SystemVisitor::<$($generic)?>::NAMES,
                        nothing,
                    )
                }
            }
        };
    };
}
