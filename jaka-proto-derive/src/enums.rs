//! Open sets of named integers and texts.

use jaka_spec::{EnumValue, to_snake, words};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::docs::Docs;
use crate::scope::ident;

/// An enum of integers.
pub(crate) fn int(place: Docs<'_>, name: &Ident, docs: &TokenStream, values: &[EnumValue<i64>]) -> TokenStream {
    let variants = variants(place, values);
    let names: Vec<_> = values.iter().map(|value| ident(&value.name)).collect();
    let wires: Vec<_> = values.iter().map(|value| Literal::i64_unsuffixed(value.wire)).collect();
    let phrases = values.iter().map(|value| to_snake(&value.name).replace('_', " "));
    quote! {
        #docs
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum #name {
            #variants
            /// A value that the spec does not list.
            Other(i64),
        }

        impl From<i64> for #name {
            fn from(value: i64) -> Self {
                match value {
                    #(#wires => Self::#names,)*
                    other => Self::Other(other),
                }
            }
        }

        impl From<#name> for i64 {
            fn from(value: #name) -> Self {
                match value {
                    #(#name::#names => #wires,)*
                    #name::Other(other) => other,
                }
            }
        }

        /// The value in words; one that the spec does not list as its number.
        impl ::core::fmt::Display for #name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                match self {
                    #(Self::#names => f.pad(#phrases),)*
                    Self::Other(other) => ::core::fmt::Display::fmt(other, f),
                }
            }
        }

        proto::__int_enum_impls!(#name);
    }
}

/// An enum of texts.
pub(crate) fn text(place: Docs<'_>, name: &Ident, docs: &TokenStream, values: &[EnumValue<String>]) -> TokenStream {
    let variants = variants(place, values);
    let names: Vec<_> = values.iter().map(|value| ident(&value.name)).collect();
    let wires: Vec<_> = values.iter().map(|value| &value.wire).collect();
    quote! {
        #docs
        #[derive(Debug, Clone, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum #name {
            #variants
            /// A value that the spec does not list.
            Other(String),
        }

        impl From<&str> for #name {
            fn from(value: &str) -> Self {
                match value {
                    #(#wires => Self::#names,)*
                    other => Self::Other(other.to_owned()),
                }
            }
        }

        impl AsRef<str> for #name {
            fn as_ref(&self) -> &str {
                match self {
                    #(Self::#names => #wires,)*
                    Self::Other(other) => other,
                }
            }
        }

        /// The value as on the wire.
        impl ::core::fmt::Display for #name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                f.pad(self.as_ref())
            }
        }

        proto::__text_enum_impls!(#name);
    }
}

/// The variants; their docs name the value on the wire.
fn variants<T: std::fmt::Debug>(place: Docs<'_>, values: &[EnumValue<T>]) -> TokenStream {
    let variants = values.iter().map(|value| {
        let newer = if value.advisory { " Taken by newer firmware only." } else { "" };
        let versions = words::versions(&value.versions).map(|known| format!(" Known to firmware {known}."));
        let versions = versions.unwrap_or_default();
        let docs = place.attributes(&format!("{}{newer}{versions} `{:?}` on the wire.", value.doc, value.wire));
        let name = ident(&value.name);
        quote!(#docs #name,)
    });
    quote!(#(#variants)*)
}
