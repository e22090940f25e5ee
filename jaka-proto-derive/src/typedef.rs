//! Named types.

use jaka_spec::words::first_sentence;
use jaka_spec::{Choice, EnumValue, Field, Type, TypeDef, TypeId, TypeKind, Variant, is_floats, to_snake};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::codec::{
    Manner, Scope, declare_variants, ident, in_place, names, read_array, read_array_in_place, read_object,
    read_object_in_place, variant_path, write_array, write_further_elements, write_further_fields, write_object,
    write_type,
};
use crate::{construct, docs, validate};

/// The type, its codec and its checks.
pub(crate) fn render(scope: Scope<'_>, (id, def): (TypeId, &TypeDef)) -> TokenStream {
    let name = ident(&def.name);
    let docs = docs::attributes(&def.doc);
    let item = match &def.kind {
        TypeKind::Object(fields) if is_used_again(scope, fields) => {
            object_in_place(scope, &name, &docs, fields, Manner::of(scope.spec, id))
        }
        TypeKind::Object(fields) => plain_object(scope, &name, &docs, fields, Manner::of(scope.spec, id)),
        TypeKind::Array { fields, exact } => array(scope, &name, &docs, fields, *exact),
        TypeKind::IntEnum(values) => int_enum(&name, &docs, values),
        TypeKind::TextEnum(values) => text_enum(&name, &docs, values),
        TypeKind::Choice(choice) => array_choice(scope, &name, &docs, choice),
        TypeKind::Wrapper(ty, unit) => wrapper(scope, &name, def, ty, unit.as_deref()),
    };
    let checks = validate::type_def(def);
    // What programs only receive, they need not make.
    let constructors = scope.spec.is_sent(id).then(|| constructors(scope, def, &name));
    quote!(#item #constructors #checks)
}

fn constructors(scope: Scope<'_>, def: &TypeDef, name: &Ident) -> Option<TokenStream> {
    match &def.kind {
        TypeKind::Object(fields) => Some(construct::object(scope, name, fields)),
        TypeKind::Array { fields, .. } if !is_floats(fields) => Some(construct::object(scope, name, fields)),
        TypeKind::Choice(choice) => Some(construct::choice(scope, name, choice)),
        // These convert from an array, or have public variants.
        TypeKind::Array { .. } | TypeKind::Wrapper(..) | TypeKind::IntEnum(_) | TypeKind::TextEnum(_) => None,
    }
}

/// Derives for a struct: `Copy` where all fields are; `Default` where all may be absent.
pub(crate) fn derives(scope: Scope<'_>, fields: &[Field]) -> TokenStream {
    let copy = scope.spec.all_copy(fields).then(|| quote!(Copy,));
    let default = fields.iter().all(|field| field.optional).then(|| quote!(Default,));
    quote!(#[derive(Debug, Clone, #copy PartialEq, #default)])
}

/// True for fields whose memory is worth using again: some own memory, and all can be read in place.
fn is_used_again(scope: Scope<'_>, fields: &[Field]) -> bool {
    !scope.spec.all_copy(fields) && in_place(fields)
}

/// A struct whose fields stand in a JSON object, and its codec.
pub(crate) fn object(scope: Scope<'_>, name: &Ident, docs: &TokenStream, fields: &[Field]) -> TokenStream {
    plain_object(scope, name, docs, fields, Manner::Strict)
}

fn plain_object(scope: Scope<'_>, name: &Ident, docs: &TokenStream, fields: &[Field], manner: Manner) -> TokenStream {
    let item = object_with(scope, name, docs, fields, &read_fields(fields, manner));
    quote!(#item proto::__object_impls!(#name);)
}

/// The same, read in place as well.
fn object_in_place(
    scope: Scope<'_>,
    name: &Ident,
    docs: &TokenStream,
    fields: &[Field],
    manner: Manner,
) -> TokenStream {
    let is_empty_at_first = fields.iter().all(|field| field.optional);
    let read = if is_empty_at_first {
        quote! {
            fn read_fields(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
                let mut this = Self::default();
                wire::Fields::read_fields_into(&mut this, reader)?;
                Ok(this)
            }
        }
    } else {
        read_fields(fields, manner)
    };
    let read_in_place = read_object_in_place(fields, manner);
    let read = quote! {
        #read

        fn read_fields_into(&mut self, reader: &mut wire::Reader<'_>) -> Result<(), wire::DecodeError> { #read_in_place }
    };
    let item = object_with(scope, name, docs, fields, &read);
    quote!(#item proto::__object_impls!(#name, in_place);)
}

fn read_fields(fields: &[Field], manner: Manner) -> TokenStream {
    let read = read_object(fields, &quote!(Self), manner);
    quote!(fn read_fields(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> { #read })
}

fn object_with(
    scope: Scope<'_>,
    name: &Ident,
    docs: &TokenStream,
    fields: &[Field],
    read: &TokenStream,
) -> TokenStream {
    let derives = derives(scope, fields);
    let declared = scope.declare(fields, &quote!(pub));
    let write = write_object(fields, |name| quote!(&self.#name));
    quote! {
        #docs
        #derives
        #[non_exhaustive]
        pub struct #name { #declared }

        impl wire::Fields for #name {
            fn write_fields(&self, out: &mut wire::Writer) { #write }

            #read
        }
    }
}

fn array(scope: Scope<'_>, name: &Ident, docs: &TokenStream, fields: &[Field], exact: bool) -> TokenStream {
    let derives = derives(scope, fields);
    let declared = scope.declare(fields, &quote!(pub));
    let write = write_array(fields, |name| quote!(&self.#name));
    let read = read_array(fields, exact, &quote!(Self));
    let in_place = (!scope.spec.all_copy(fields)).then(|| {
        let read = read_array_in_place(fields, exact, |name| quote!(&mut self.#name));
        decode_into(&quote!(reader.begin_array()?; #read))
    });
    // What converts from an array of numbers cannot grow.
    let grows = (!is_floats(fields)).then(|| quote!(#[non_exhaustive]));
    let conversions = is_floats(fields).then(|| float_conversions(name, fields));
    quote! {
        #docs
        #derives
        #grows
        pub struct #name { #declared }

        impl wire::Encode for #name {
            fn encode(&self, out: &mut wire::Writer) {
                out.raw("[");
                #write
                out.raw("]");
            }
        }

        impl wire::Decode for #name {
            fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
                reader.begin_array()?;
                #read
            }

            #in_place
        }

        proto::__serde_impls!(#name);
        #conversions
    }
}

fn decode_into(statements: &TokenStream) -> TokenStream {
    quote! {
        fn decode_into(&mut self, reader: &mut wire::Reader<'_>) -> Result<(), wire::DecodeError> { #statements }
    }
}

fn float_conversions(name: &Ident, fields: &[Field]) -> TokenStream {
    let names = names(fields);
    let len = Literal::usize_unsuffixed(fields.len());
    quote! {
        impl From<[f64; #len]> for #name {
            fn from([#(#names),*]: [f64; #len]) -> Self {
                Self { #(#names),* }
            }
        }

        impl From<#name> for [f64; #len] {
            fn from(value: #name) -> Self {
                [#(value.#names),*]
            }
        }
    }
}

fn wrapper(scope: Scope<'_>, name: &Ident, def: &TypeDef, ty: &Type, unit: Option<&str>) -> TokenStream {
    let (first, rest) = first_sentence(&def.doc);
    let unit = unit.map(|unit| format!(" In {unit}.")).unwrap_or_default();
    let docs = docs::attributes(&format!("{first}{unit}{rest}"));
    let inner = scope.rust_type(ty);
    let copy = scope.spec.is_copy(ty).then(|| quote!(Copy,));
    let write = write_type(ty, &quote!(&self.0));
    let in_place = copy.is_none().then(|| decode_into(&quote!(self.0.decode_into(reader))));
    quote! {
        #docs
        #[derive(Debug, Clone, #copy PartialEq)]
        pub struct #name(pub #inner);

        impl From<#inner> for #name {
            fn from(value: #inner) -> Self {
                Self(value)
            }
        }

        impl From<#name> for #inner {
            fn from(value: #name) -> Self {
                value.0
            }
        }

        impl wire::Encode for #name {
            fn encode(&self, out: &mut wire::Writer) { #write }
        }

        impl wire::Decode for #name {
            fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
                wire::Decode::decode(reader).map(Self)
            }

            #in_place
        }

        proto::__serde_impls!(#name);
    }
}

/// The variants of an enum, with docs that name the value on the wire.
fn enum_variants<T: std::fmt::Debug>(values: &[EnumValue<T>]) -> TokenStream {
    let variants = values.iter().map(|value| {
        let newer = if value.advisory { " Taken by newer firmware only." } else { "" };
        let docs = docs::attributes(&format!("{}{newer} `{:?}` on the wire.", value.doc, value.wire));
        let name = ident(&value.name);
        quote!(#docs #name)
    });
    quote!(#(#variants),*)
}

fn int_enum(name: &Ident, docs: &TokenStream, values: &[EnumValue<i64>]) -> TokenStream {
    let variants = enum_variants(values);
    let names: Vec<_> = values.iter().map(|value| ident(&value.name)).collect();
    let wires: Vec<_> = values.iter().map(|value| Literal::i64_unsuffixed(value.wire)).collect();
    let phrases: Vec<_> = values.iter().map(|value| to_snake(&value.name).replace('_', " ")).collect();
    quote! {
        #docs
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum #name {
            #variants,
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

fn text_enum(name: &Ident, docs: &TokenStream, values: &[EnumValue<String>]) -> TokenStream {
    let variants = enum_variants(values);
    let names: Vec<_> = values.iter().map(|value| ident(&value.name)).collect();
    let wires: Vec<_> = values.iter().map(|value| &value.wire).collect();
    quote! {
        #docs
        #[derive(Debug, Clone, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum #name {
            #variants,
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
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                f.pad(self.as_ref())
            }
        }

        proto::__text_enum_impls!(#name);
    }
}

/// A choice written as an array that begins with its tag.
fn array_choice(scope: Scope<'_>, name: &Ident, docs: &TokenStream, choice: &Choice) -> TokenStream {
    let variants = declare_variants(scope, choice);
    let write = choice.variants.iter().map(|variant| {
        let (path, names, begin) = (variant_path(variant), names(&variant.fields), format!("[{}", variant.wire));
        let write = write_further_elements(&variant.fields, |name| quote!(#name));
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
    let in_place = choice.variants.iter().any(|variant| !scope.spec.all_copy(&variant.fields)).then_some(in_place);
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
            fn encode(&self, out: &mut wire::Writer) {
                match self {
                    #(#write)*
                    Self::Other(value) => wire::Encode::encode(value, out),
                }
            }
        }

        impl wire::Decode for #name {
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

/// A choice whose tag and fields stand in a JSON object: a request.
pub(crate) fn object_choice(scope: Scope<'_>, name: &Ident, docs: &TokenStream, choice: &Choice) -> TokenStream {
    let variants = declare_variants(scope, choice);
    let all_copy = choice.variants.iter().all(|variant| scope.spec.all_copy(&variant.fields));
    let copy = all_copy.then(|| quote!(Copy,));
    let tag_key = &choice.tag;
    let key = choice.key();
    let write = choice.variants.iter().map(|variant| {
        let (path, names, tag) = (variant_path(variant), names(&variant.fields), format!("{key}{}", variant.wire));
        let write = write_further_fields(&variant.fields, |name| quote!(#name));
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
            fn write_fields(&self, out: &mut wire::Writer) {
                match self { #(#write)* }
            }

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
