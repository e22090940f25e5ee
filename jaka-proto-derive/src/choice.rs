//! Choices: enums with a tag that selects the variant.

use jaka_spec::{Choice, Variant};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::codec::{Manner, decode_into, read_array, read_array_in_place, read_object, write_further};
use crate::scope::{Scope, ident, names};

/// A choice written as an array that begins with its tag.
pub(crate) fn array(scope: Scope<'_>, name: &Ident, docs: &TokenStream, choice: &Choice) -> TokenStream {
    let variants = declare_variants(scope, choice);
    let write = choice.variants.iter().map(|variant| {
        let (path, names, begin) = (variant_path(variant), names(&variant.fields), format!("[{}", variant.wire));
        let write = write_further(&variant.fields, |name| quote!(#name));
        quote!(#path { #(#names),* } => { out.raw(#begin); #write out.raw("]"); })
    });
    let read = choice.variants.iter().map(|variant| {
        let tag = tag(variant);
        let read = read_array(&variant.fields, false, &variant_path(variant));
        quote!(#tag => { #read })
    });
    let read_in_place = choice.variants.iter().filter(|variant| !scope.spec.all_copy(&variant.fields)).map(|variant| {
        let (path, names, tag) = (variant_path(variant), names(&variant.fields), tag(variant));
        let read = read_array_in_place(&variant.fields, false, |name| quote!(#name));
        quote!((#tag, #path { #(#names),* }) => { #read })
    });
    let in_place = decode_into(&quote! {
        let start = reader.mark();
        reader.begin_array()?;
        match (reader.element::<i64>("kind")?, &mut *self) {
            #(#read_in_place)*
            _ => {
                reader.go_back(start);
                *self = wire::Decode::decode(reader)?;
                Ok(())
            }
        }
    });
    let inline = scope.inline_reads();
    let owns = choice.variants.iter().any(|variant| !scope.spec.all_copy(&variant.fields));
    let in_place = owns.then(|| quote!(#inline #in_place));
    quote! {
        #docs
        #[derive(Debug, Clone, PartialEq)]
        #[non_exhaustive]
        pub enum #name {
            #variants,
            /// A kind that the spec does not list, as raw JSON.
            Other(wire::Value),
        }

        impl wire::Encode for #name {
            #[inline]
            fn encode(&self, out: &mut wire::Writer) {
                match self {
                    #(#write)*
                    Self::Other(value) => wire::Encode::encode(value, out),
                }
            }
        }

        impl wire::Decode for #name {
            #inline
            fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
                let start = reader.mark();
                reader.begin_array()?;
                match reader.element::<i64>("kind")? {
                    #(#read)*
                    _ => {
                        reader.go_back(start);
                        wire::Decode::decode(reader).map(Self::Other)
                    }
                }
            }

            #in_place
        }

        proto::__serde_impls!(#name);
    }
}

/// A choice with tag and fields in a JSON object: a request.
pub(crate) fn object(scope: Scope<'_>, name: &Ident, docs: &TokenStream, choice: &Choice) -> TokenStream {
    let variants = declare_variants(scope, choice);
    let all_copy = choice.variants.iter().all(|variant| scope.spec.all_copy(&variant.fields));
    let copy = all_copy.then(|| quote!(Copy,));
    let tag_key = &choice.tag;
    let key = choice.key();
    let write = choice.variants.iter().map(|variant| {
        let (path, names, tag) = (variant_path(variant), names(&variant.fields), format!("{key}{}", variant.wire));
        let write = write_further(&variant.fields, |name| quote!(#name));
        quote!(#path { #(#names),* } => { out.key(#tag); #write })
    });
    let read = choice.variants.iter().map(|variant| {
        let (value, read) = (tag(variant), read_object(&variant.fields, &variant_path(variant), Manner::Strict));
        quote!(#value => { #read })
    });
    let known: Vec<_> = choice.variants.iter().map(|variant| variant.wire.to_string()).collect();
    let known = format!("one of {}", known.join(", "));
    quote! {
        #docs
        #[derive(Debug, Clone, #copy PartialEq)]
        #[non_exhaustive]
        pub enum #name { #variants }

        impl wire::Fields for #name {
            #[inline]
            fn write_fields(&self, out: &mut wire::Writer) {
                match self { #(#write)* }
            }

            #[inline]
            fn read_fields(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
                match reader.tag(#tag_key, #tag_key)? {
                    #(#read)*
                    other => Err(wire::DecodeError::unfit(#known, &other.to_string()).in_field(#tag_key)),
                }
            }
        }

        proto::__object_impls!(#name);
    }
}

fn tag(variant: &Variant) -> Literal {
    Literal::i64_unsuffixed(variant.wire)
}

/// The variants of a choice for an enum.
fn declare_variants(scope: Scope<'_>, choice: &Choice) -> TokenStream {
    let variants = choice.variants.iter().map(|variant| {
        let (docs, name) = (scope.docs.attributes(&variant.doc), ident(&variant.name));
        let fields = scope.declare(&variant.fields, &TokenStream::new());
        let body = (!variant.fields.is_empty()).then(|| quote!({ #fields }));
        quote!(#docs #[non_exhaustive] #name #body)
    });
    quote!(#(#variants),*)
}

/// The pattern that takes a variant apart, and the expression that puts it together.
pub(crate) fn variant_path(variant: &Variant) -> TokenStream {
    let name = ident(&variant.name);
    quote!(Self::#name)
}
