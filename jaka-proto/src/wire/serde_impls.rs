//! serde's traits for generated types, by way of the wire's own JSON, so that there is one codec and not two.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de, ser};
use serde_json::Value;

use super::{Decode, Encode, Reader, Typed, Writer};

/// Serialises a value as its JSON on the wire.
pub fn serialize<T: Encode, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
    let mut out = Writer::new();
    value.encode(&mut out);
    let json: Value = serde_json::from_str(out.as_str()).map_err(ser::Error::custom)?;
    json.serialize(serializer)
}

/// Deserialises a value from its JSON on the wire. Nothing is left out, also not of a status packet.
pub fn deserialize<'de, T: Decode, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    let json = Value::deserialize(deserializer)?.to_string();
    let mut reader = Reader::new(&json);
    let value = T::decode(&mut reader).map_err(de::Error::custom)?;
    reader.take_unfit().into_iter().next().map_or(Ok(value), |unfit| Err(de::Error::custom(unfit)))
}

/// Implements serde's traits for types that implement [`Encode`] and [`Decode`].
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_impls {
    ($type:ident $(<$param:ident>)?) => {
        impl $(<$param: $crate::wire::Encode>)? $crate::__private::serde::Serialize for $type $(<$param>)? {
            fn serialize<S>(&self, serializer: S) -> ::core::result::Result<S::Ok, S::Error>
            where
                S: $crate::__private::serde::Serializer,
            {
                $crate::wire::serialize(self, serializer)
            }
        }

        impl<'de $(, $param: $crate::wire::Decode)?> $crate::__private::serde::Deserialize<'de> for $type $(<$param>)? {
            fn deserialize<D>(deserializer: D) -> ::core::result::Result<Self, D::Error>
            where
                D: $crate::__private::serde::Deserializer<'de>,
            {
                $crate::wire::deserialize(deserializer)
            }
        }
    };
}

/// Implements the traits of a type whose fields stand in a JSON object, and which may be read in place.
#[doc(hidden)]
#[macro_export]
macro_rules! __object_impls {
    ($type:ident) => {
        $crate::__object_impls!(@impls $type {});
    };
    ($type:ident, in_place) => {
        $crate::__object_impls!(@impls $type {
            #[inline]
            fn decode_into(
                &mut self,
                reader: &mut $crate::wire::Reader<'_>,
            ) -> ::core::result::Result<(), $crate::wire::DecodeError> {
                $crate::wire::Fields::read_fields_into(self, reader)
            }
        });
    };
    (@impls $type:ident { $($in_place:tt)* }) => {
        impl $crate::wire::Encode for $type {
            #[inline]
            fn encode(&self, out: &mut $crate::wire::Writer) {
                out.raw("{");
                $crate::wire::Fields::write_fields(self, out);
                out.raw("}");
            }
        }

        impl $crate::wire::Decode for $type {
            #[inline]
            fn decode(
                reader: &mut $crate::wire::Reader<'_>,
            ) -> ::core::result::Result<Self, $crate::wire::DecodeError> {
                $crate::wire::Fields::read_fields(reader)
            }

            $($in_place)*
        }

        $crate::__serde_impls!($type);
    };
}

/// Implements the traits of an enum that converts from and into an integer.
#[doc(hidden)]
#[macro_export]
macro_rules! __int_enum_impls {
    ($type:ident) => {
        impl $crate::wire::Encode for $type {
            #[inline]
            fn encode(&self, out: &mut $crate::wire::Writer) {
                out.int((*self).into());
            }
        }

        impl $crate::wire::Decode for $type {
            #[inline]
            fn decode(
                reader: &mut $crate::wire::Reader<'_>,
            ) -> ::core::result::Result<Self, $crate::wire::DecodeError> {
                <i64 as $crate::wire::Decode>::decode(reader).map(Self::from)
            }
        }

        $crate::__serde_impls!($type);
    };
}

/// Implements the traits of an enum that converts from and into a string.
#[doc(hidden)]
#[macro_export]
macro_rules! __text_enum_impls {
    ($type:ident) => {
        impl $crate::wire::Encode for $type {
            #[inline]
            fn encode(&self, out: &mut $crate::wire::Writer) {
                out.text(self.as_ref());
            }
        }

        impl $crate::wire::Decode for $type {
            #[inline]
            fn decode(
                reader: &mut $crate::wire::Reader<'_>,
            ) -> ::core::result::Result<Self, $crate::wire::DecodeError> {
                reader.text().map(|text| Self::from(&*text))
            }
        }

        $crate::__serde_impls!($type);
    };
}

crate::__serde_impls!(Typed<T>);
