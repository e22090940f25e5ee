//! Fields: how they are declared, written and read.

use jaka_spec::{Choice, Field, Spec, Topic, Type, Variant};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::docs;

/// Where generated code stands, and so how it names types: those of its own topic plainly, others by their topic's module.
#[derive(Clone, Copy)]
pub(crate) struct Scope<'s> {
    pub(crate) spec: &'s Spec,
    /// The topic whose module it is; none outside of all of them.
    pub(crate) topic: Option<&'s Topic>,
    /// The path of the module that has the other topics' modules.
    pub(crate) elsewhere: &'s TokenStream,
}

impl Scope<'_> {
    /// The Rust type, as named from inside the topic's module.
    pub(crate) fn rust_type(self, ty: &Type) -> TokenStream {
        match ty {
            Type::Bool { .. } => quote!(bool),
            Type::Int => quote!(i64),
            Type::Float => quote!(f64),
            Type::Text => quote!(String),
            Type::Json => quote!(wire::Value),
            Type::Python(inner) => self.rust_type(inner),
            Type::List(element) => {
                let element = self.rust_type(element);
                quote!(Vec<#element>)
            }
            Type::Array(element, len) => {
                let (element, len) = (self.rust_type(element), Literal::usize_unsuffixed(*len));
                quote!([#element; #len])
            }
            Type::Named(name) => self.path(name),
        }
    }

    /// The path of a named type.
    pub(crate) fn path(self, name: &str) -> TokenStream {
        let is_own = self.topic.is_some_and(|topic| topic.types.iter().any(|def| def.name == name));
        let topic = self.spec.topic_of_type(name).filter(|_| !is_own);
        let module = topic.map(|topic| self.module(topic));
        let name = ident(name);
        quote!(#module #name)
    }

    /// The path of another topic's module.
    pub(crate) fn module(self, topic: &Topic) -> TokenStream {
        let (elsewhere, module) = (self.elsewhere, ident(&topic.name));
        quote!(#elsewhere::#module::)
    }

    /// The type of a struct's field.
    pub(crate) fn field_type(self, field: &Field) -> TokenStream {
        let mut ty = self.rust_type(&field.ty);
        if field.or_raw {
            ty = quote!(wire::Typed<#ty>);
        }
        if field.optional { quote!(Option<#ty>) } else { ty }
    }

    /// `name: type` for each field, with docs; `vis` stands before each.
    pub(crate) fn declare(self, fields: &[Field], vis: &TokenStream) -> TokenStream {
        let fields = fields.iter().map(|field| {
            let docs = docs::field(field);
            let name = ident(&field.name);
            let ty = self.field_type(field);
            quote!(#docs #vis #name: #ty)
        });
        quote!(#(#fields),*)
    }
}

pub(crate) fn ident(name: &str) -> Ident {
    format_ident!("{name}")
}

/// The names of the fields, to destructure or construct with.
pub(crate) fn names(fields: &[Field]) -> Vec<Ident> {
    fields.iter().map(|field| ident(&field.name)).collect()
}

/// Statements that write the fields of an object; `value` turns a field's name into a reference to its value.
pub(crate) fn write_object(fields: &[Field], value: impl Fn(&Ident) -> TokenStream) -> TokenStream {
    let fields = fields.iter().map(|field| {
        let key = field.key();
        write_field(field, &quote!(out.key(#key);), &value(&ident(&field.name)))
    });
    quote!(#(#fields)*)
}

/// Statements that write the elements of an array, without its brackets.
pub(crate) fn write_array(fields: &[Field], value: impl Fn(&Ident) -> TokenStream) -> TokenStream {
    let fields = fields.iter().map(|field| write_field(field, &quote!(out.comma();), &value(&ident(&field.name))));
    quote!(#(#fields)*)
}

fn write_field(field: &Field, before: &TokenStream, value: &TokenStream) -> TokenStream {
    if field.optional {
        let write = write_value(field, &quote!(value));
        quote!(if let Some(value) = #value { #before #write })
    } else {
        let write = write_value(field, value);
        quote!(#before #write)
    }
}

fn write_value(field: &Field, value: &TokenStream) -> TokenStream {
    if !field.or_raw {
        return write_type(&field.ty, value);
    }
    let write = write_type(&field.ty, &quote!(value));
    quote! {
        match #value {
            wire::Typed::Known(value) => { #write }
            wire::Typed::Raw(value) => wire::Encode::encode(value, out),
        }
    }
}

/// A statement that writes the value behind the reference `value`.
pub(crate) fn write_type(ty: &Type, value: &TokenStream) -> TokenStream {
    match ty {
        Type::Bool { off, on } if off != "false" || on != "true" => quote!(out.choose(*#value, #off, #on);),
        Type::List(element) | Type::Array(element, _) if is_truth(element) => {
            let write = write_type(element, &quote!(item));
            quote!(out.array(#value, |out, item| { #write });)
        }
        Type::Python(inner) => {
            let write = write_type(inner, value);
            quote!(out.python(|out| { #write });)
        }
        _ => quote!(wire::Encode::encode(#value, out);),
    }
}

/// True for a truth value, and for an array of them.
fn is_truth(ty: &Type) -> bool {
    match ty {
        Type::List(element) | Type::Array(element, _) => is_truth(element),
        other => matches!(other, Type::Bool { .. }),
    }
}

/// Statements and an expression that read an object and construct `constructor` from its fields.
pub(crate) fn read_object(fields: &[Field], constructor: &TokenStream) -> TokenStream {
    let names = names(fields);
    let arms = fields.iter().map(read_arm);
    let values = fields.iter().map(|field| {
        let name = ident(&field.name);
        if field.optional {
            return quote!(#name);
        }
        let (text, key) = (&field.name, &field.wire);
        quote!(#name: #name.ok_or_else(|| wire::DecodeError::missing(#text, #key))?)
    });
    quote! {
        #(let mut #names = None;)*
        reader.begin_object()?;
        while let Some(key) = reader.next_key()? {
            match &*key {
                #(#arms)*
                _ => reader.skip()?,
            }
        }
        Ok(#constructor { #(#values),* })
    }
}

fn read_arm(field: &Field) -> TokenStream {
    let (key, text, name) = (&field.wire, &field.name, ident(&field.name));
    match &field.ty {
        Type::Bool { off, on } if field.ty.has_words() => {
            let (off, on) = (off.trim_matches('"'), on.trim_matches('"'));
            quote!(#key => reader.field_word(#text, &mut #name, #off, #on)?,)
        }
        Type::Python(_) => quote!(#key => reader.field_python(#text, &mut #name)?,),
        _ => quote!(#key => reader.field(#text, &mut #name)?,),
    }
}

/// Statements and an expression that read the elements of an array that has been entered.
pub(crate) fn read_array(fields: &[Field], exact: bool, constructor: &TokenStream) -> TokenStream {
    let values = fields.iter().map(|field| {
        let (text, name) = (&field.name, ident(&field.name));
        let method = if field.optional { quote!(optional_element) } else { quote!(element) };
        quote!(#name: reader.#method(#text)?)
    });
    let end = if exact { quote!(end_exact_array) } else { quote!(end_array) };
    quote! {
        let this = #constructor { #(#values),* };
        reader.#end()?;
        Ok(this)
    }
}

/// The variants of a choice as they stand in an enum.
pub(crate) fn declare_variants(scope: Scope<'_>, choice: &Choice) -> TokenStream {
    let variants = choice.variants.iter().map(|variant| {
        let docs = docs::attributes(&variant.doc);
        let name = ident(&variant.name);
        let fields = scope.declare(&variant.fields, &TokenStream::new());
        if variant.fields.is_empty() { quote!(#docs #name) } else { quote!(#docs #name { #fields }) }
    });
    quote!(#(#variants),*)
}

/// The pattern that takes a variant apart, and the expression that puts it together.
pub(crate) fn variant_path(variant: &Variant) -> TokenStream {
    let name = ident(&variant.name);
    quote!(Self::#name)
}
