//! Functions by which programs make values: constructors of the required fields, and setters of the optional ones.
//!
//! A new optional field adds a setter and leaves the existing functions as they are.

use jaka_spec::{Choice, EnumValue, Field, Type, TypeKind, to_snake};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::scope::{Scope, ident};

/// Most arguments of a function before clippy asks for fewer.
const MANY: usize = 7;

/// The constructors and setters of a struct.
pub(crate) fn object(scope: Scope<'_>, name: &Ident, fields: &[Field]) -> TokenStream {
    let new = new(scope, fields);
    let kinds = fields.iter().filter(|field| field.constructors && !field.optional);
    let kinds = kinds.map(|field| of_each_value(scope, field, fields));
    let setters = fields.iter().filter(|field| field.optional).map(|field| setter(scope, field));
    quote! {
        impl #name {
            #new
            #(#kinds)*
            #(#setters)*
        }
    }
}

/// A constructor for each variant of a choice.
pub(crate) fn choice(scope: Scope<'_>, name: &Ident, choice: &Choice) -> TokenStream {
    let constructors = choice.variants.iter().map(|variant| {
        let (path, values) = (ident(&variant.name), values(scope, &variant.fields));
        let name = function_name(&variant.name, &[]);
        function(scope, &variant.doc, &name, &variant.fields, &quote!(Self::#path { #values }))
    });
    quote!(impl #name { #(#constructors)* })
}

fn new(scope: Scope<'_>, fields: &[Field]) -> TokenStream {
    let doc = if fields.iter().all(|field| field.optional) {
        "Without any optional field."
    } else {
        "With the required fields alone."
    };
    let values = values(scope, fields);
    function(scope, doc, &ident(NEW), fields, &quote!(Self { #values }))
}

/// Constructors for what `field`, an enum, selects.
fn of_each_value(scope: Scope<'_>, field: &Field, fields: &[Field]) -> TokenStream {
    let Type::Named(id) = &field.ty else { return TokenStream::new() };
    let values: Vec<(&str, &str)> = match &scope.spec[*id].kind {
        TypeKind::IntEnum(values) => names_and_docs(values),
        TypeKind::TextEnum(values) => names_and_docs(values),
        _ => Vec::new(),
    };
    let (ty, selected) = (scope.path(*id), ident(&field.name));
    let others: Vec<_> = fields.iter().filter(|other| other.name != field.name).cloned().collect();
    let arguments: Vec<_> = fields.iter().filter(|field| !field.optional).map(|field| ident(&field.name)).collect();
    let functions = values.into_iter().map(|(value, doc)| {
        let (name, value) = (function_name(value, fields), ident(value));
        let arguments = arguments
            .iter()
            .map(|argument| if *argument == selected { quote!(#ty::#value) } else { quote!(#argument) });
        function(scope, doc, &name, &others, &quote!(Self::new(#(#arguments),*)))
    });
    quote!(#(#functions)*)
}

fn names_and_docs<T>(values: &[EnumValue<T>]) -> Vec<(&str, &str)> {
    values.iter().map(|value| (&*value.name, &*value.doc)).collect()
}

/// The name of the constructor for a variant. An underscore follows where Rust or another function has the name.
pub(crate) fn function_name(variant: &str, fields: &[Field]) -> Ident {
    let name = to_snake(variant);
    let is_taken = name == NEW || fields.iter().any(|field| field.optional && field.name == name);
    if is_taken || !jaka_spec::is_snake(&name) { ident(&format!("{name}_")) } else { ident(&name) }
}

/// The name of the constructor of the required fields.
const NEW: &str = "new";

/// The name of the setter of an optional field.
pub(crate) fn setter_name(field: &Field) -> Ident {
    if field.name == NEW { ident("new_") } else { ident(&field.name) }
}

fn setter(scope: Scope<'_>, field: &Field) -> TokenStream {
    let docs = scope.docs.setter(field);
    let name = ident(&field.name);
    let function = setter_name(field);
    let (ty, value) = argument(scope, field);
    quote! {
        #docs
        #[must_use]
        pub fn #function(mut self, #name: #ty) -> Self {
            self.#name = Some(#value);
            self
        }
    }
}

/// A constructor of the required fields.
fn function(scope: Scope<'_>, doc: &str, name: &Ident, fields: &[Field], body: &TokenStream) -> TokenStream {
    let docs = scope.docs.constructor(doc, fields);
    let required: Vec<_> = fields.iter().filter(|field| !field.optional).collect();
    let parameters = required.iter().map(|field| {
        let (name, (ty, _)) = (ident(&field.name), argument(scope, field));
        quote!(#name: #ty)
    });
    let many = (required.len() > MANY).then(|| quote!(#[allow(clippy::too_many_arguments)]));
    let constant = required.iter().all(|field| !scope.spec.is_converted(field)).then(|| quote!(const));
    quote! {
        #docs
        #[must_use]
        #many
        pub #constant fn #name(#(#parameters),*) -> Self { #body }
    }
}

/// `name: value` for each field, made of a parameter of its name, or of nothing where the field is optional.
fn values(scope: Scope<'_>, fields: &[Field]) -> TokenStream {
    let values = fields.iter().map(|field| {
        let (name, (_, value)) = (ident(&field.name), argument(scope, field));
        if field.optional {
            return quote!(#name: None);
        }
        if value.to_string() == field.name { quote!(#name) } else { quote!(#name: #value) }
    });
    quote!(#(#values),*)
}

/// The type of the parameter that stands for a field, and the field's value, made of the parameter.
pub(crate) fn argument(scope: Scope<'_>, field: &Field) -> (TokenStream, TokenStream) {
    let name = ident(&field.name);
    let ty = scope.required_type(field);
    if scope.spec.is_converted(field) {
        return (quote!(impl Into<#ty>), quote!(#name.into()));
    }
    (ty, quote!(#name))
}
