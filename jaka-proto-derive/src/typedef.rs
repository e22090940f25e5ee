//! Named types.

use std::collections::BTreeSet;

use jaka_spec::words::first_sentence;
use jaka_spec::{Field, Type, TypeDef, TypeId, TypeKind, is_floats};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::codec::{
    Manner, decode_into, in_place, read_array, read_array_in_place, read_object, read_object_in_place, write_all,
    write_type,
};
use crate::scope::{Scope, ident, names};
use crate::{choice, construct, enums, validate};

/// The type, its codec and its checks.
pub(crate) fn render(scope: Scope<'_>, (id, def): (TypeId, &TypeDef), sent: &BTreeSet<TypeId>) -> TokenStream {
    let name = ident(&def.name);
    let docs = scope.docs.attributes(&def.doc);
    let item = match &def.kind {
        TypeKind::Object(fields) => object_type(scope, &name, &docs, fields, Manner::of(scope.spec, id)),
        TypeKind::Array { fields, exact } => array(scope, &name, &docs, fields, *exact),
        TypeKind::IntEnum(values) => enums::int(scope.docs, &name, &docs, values),
        TypeKind::TextEnum(values) => enums::text(scope.docs, &name, &docs, values),
        TypeKind::Choice(choice) => choice::array(scope, &name, &docs, choice),
        TypeKind::Wrapper(ty, unit) => wrapper(scope, &name, def, ty, unit.as_deref()),
    };
    let checks = validate::type_def(scope, def);
    // What programs only receive, they need not make.
    let constructors = sent.contains(&id).then(|| constructors(scope, def, &name));
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
fn derives(scope: Scope<'_>, fields: &[Field]) -> TokenStream {
    let copy = scope.spec.all_copy(fields).then(|| quote!(Copy,));
    let default = fields.iter().all(|field| field.optional).then(|| quote!(Default,));
    quote!(#[derive(Debug, Clone, #copy PartialEq, #default)])
}

/// A request or reply: a struct with fields in a JSON object, and its codec.
pub(crate) fn object(scope: Scope<'_>, name: &Ident, docs: &TokenStream, fields: &[Field]) -> TokenStream {
    let read = read_fields(fields, Manner::Strict);
    object_with(scope, name, docs, fields, &quote!(#[inline] #read), &quote!(proto::__object_impls!(#name);))
}

/// A named type that is a JSON object: a struct and its codec. It is read in place too if that is possible and some of
/// its fields own memory, to use that memory again.
fn object_type(scope: Scope<'_>, name: &Ident, docs: &TokenStream, fields: &[Field], manner: Manner) -> TokenStream {
    let inline = scope.inline_reads();
    if scope.spec.all_copy(fields) || !in_place(fields) {
        let read = read_fields(fields, manner);
        let impls = quote!(proto::__object_impls!(#name););
        return object_with(scope, name, docs, fields, &quote!(#inline #read), &impls);
    }
    let read = if fields.iter().all(|field| field.optional) {
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
        #inline
        #read

        #inline
        fn read_fields_into(&mut self, reader: &mut wire::Reader<'_>) -> Result<(), wire::DecodeError> { #read_in_place }
    };
    object_with(scope, name, docs, fields, &read, &quote!(proto::__object_impls!(#name, in_place);))
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
    impls: &TokenStream,
) -> TokenStream {
    let derives = derives(scope, fields);
    let declared = scope.declare(fields, &quote!(pub));
    let write = write_all(fields, |name| quote!(&self.#name));
    quote! {
        #docs
        #derives
        #[non_exhaustive]
        pub struct #name { #declared }

        impl wire::Fields for #name {
            #[inline]
            fn write_fields(&self, out: &mut wire::Writer) { #write }

            #read
        }

        #impls
    }
}

fn array(scope: Scope<'_>, name: &Ident, docs: &TokenStream, fields: &[Field], exact: bool) -> TokenStream {
    let derives = derives(scope, fields);
    let declared = scope.declare(fields, &quote!(pub));
    let write = write_all(fields, |name| quote!(&self.#name));
    let read = read_array(fields, exact, &quote!(Self));
    let inline = scope.inline_reads();
    let in_place = (!scope.spec.all_copy(fields)).then(|| {
        let read = read_array_in_place(fields, exact, |name| quote!(&mut self.#name));
        let decode = decode_into(&quote!(reader.begin_array()?; #read));
        quote!(#inline #decode)
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
            #[inline]
            fn encode(&self, out: &mut wire::Writer) {
                out.raw("[");
                #write
                out.raw("]");
            }
        }

        impl wire::Decode for #name {
            #inline
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
    let docs = scope.docs.attributes(&format!("{first}{unit}{rest}"));
    let inner = scope.rust_type(ty);
    let copy = scope.spec.is_copy(ty).then(|| quote!(Copy,));
    let write = write_type(ty, &quote!(&self.0));
    let inline = scope.inline_reads();
    let in_place = copy.is_none().then(|| {
        let decode = decode_into(&quote!(self.0.decode_into(reader)));
        quote!(#inline #decode)
    });
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
            #[inline]
            fn encode(&self, out: &mut wire::Writer) { #write }
        }

        impl wire::Decode for #name {
            #inline
            fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
                wire::Decode::decode(reader).map(Self)
            }

            #in_place
        }

        proto::__serde_impls!(#name);
    }
}
