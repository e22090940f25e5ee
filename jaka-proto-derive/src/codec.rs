//! Fields: how they are declared, written and read.

use jaka_spec::{Field, Scalar, Spec, Type, TypeId};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::scope::{ident, names};

/// Statements that write the fields of an object, or the elements of an array, without its brackets; `value` turns a
/// name into a reference to its value.
pub(crate) fn write_all(fields: &[Field], value: impl Fn(&Ident) -> TokenStream) -> TokenStream {
    // After a field that is always there, a comma is always due, and is one text with the key.
    let always = fields.iter().position(|field| !field.optional).map_or(fields.len(), |first| first + 1);
    let (first, rest) = fields.split_at(always);
    let first = first.iter().enumerate().map(|(at, field)| {
        let key = field.key();
        let before = match (at, field.wire.is_empty()) {
            (_, false) => quote!(out.key(#key);),
            (0, true) => TokenStream::new(),
            (_, true) => quote!(out.comma();),
        };
        write_field(field, &before, &value(&ident(&field.name)))
    });
    let rest = write_further(rest, &value);
    let nothing = fields.is_empty().then(|| quote!(let _ = out;));
    quote!(#(#first)* #rest #nothing)
}

/// Statements that write the fields or elements after another one.
pub(crate) fn write_further(fields: &[Field], value: impl Fn(&Ident) -> TokenStream) -> TokenStream {
    let fields = fields.iter().map(|field| {
        let key = if field.wire.is_empty() { ",".to_owned() } else { format!(",{}", field.key()) };
        write_field(field, &quote!(out.raw(#key);), &value(&ident(&field.name)))
    });
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
        Type::Scalar(Scalar::Bool { off, on }) if off != "false" || on != "true" => {
            quote!(out.choose(*#value, #off, #on);)
        }
        Type::List(element) | Type::Array(element, _) if is_truth(element) => {
            let write = write_type(element, &quote!(item));
            quote!(out.array(#value, |out, item| { #write });)
        }
        Type::Python(inner) => {
            let write = write_type(inner, value);
            quote!(out.python(|out| { #write });)
        }
        Type::Scalar(_) | Type::Named(_) | Type::List(_) | Type::Array(..) => {
            quote!(wire::Encode::encode(#value, out);)
        }
    }
}

/// True for a truth value, and for an array of them.
fn is_truth(ty: &Type) -> bool {
    match ty {
        Type::List(element) | Type::Array(element, _) => is_truth(element),
        other => matches!(other, Type::Scalar(Scalar::Bool { .. })),
    }
}

/// Manner of reading an object.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Manner {
    /// A value that does not fit is an error.
    Strict,
    /// A status packet: a value that does not fit is left out.
    Status,
    /// A subset of a status packet: as a status packet, but the values of other keys are not looked at.
    StatusSubset,
}

impl Manner {
    /// Returns the manner of reading a named type.
    pub(crate) fn of(spec: &Spec, id: TypeId) -> Self {
        if spec.status_type() == Some(id) { Self::Status } else { Self::Strict }
    }

    /// Name of the reader's method that goes to the next key.
    fn next(self) -> TokenStream {
        if self == Self::StatusSubset { quote!(next_wanted) } else { quote!(next_field) }
    }
}

/// Statements and an expression that read an object and construct `constructor` from its fields.
pub(crate) fn read_object(fields: &[Field], constructor: &TokenStream, manner: Manner) -> TokenStream {
    let names = names(fields);
    let arms = fields.iter().enumerate().map(|(at, field)| {
        let (name, method) = (ident(&field.name), read_method(field));
        if manner == Manner::Strict || !field.optional {
            return arm(at, field, &method, &quote!(&mut #name));
        }
        let (text, at, read) = (&field.name, Literal::usize_unsuffixed(at), read_call(field, &method, &quote!(slot)));
        quote!(#at => reader.status_field(#text, &mut #name, &keys, |reader, slot| #read)?,)
    });
    let values = fields.iter().map(|field| {
        let name = ident(&field.name);
        if field.optional {
            return quote!(#name);
        }
        let (text, key) = (&field.name, &field.wire);
        quote!(#name: #name.ok_or_else(|| wire::DecodeError::missing(#text, #key))?)
    });
    let walk = walk_object(fields, arms, manner);
    quote! {
        #(let mut #names = None;)*
        #walk
        Ok(#constructor { #(#values),* })
    }
}

/// Statements and an expression that read an object into the fields of `self`, whose memory is used again.
pub(crate) fn read_object_in_place(fields: &[Field], manner: Manner) -> TokenStream {
    let arms = fields.iter().enumerate().map(|(at, field)| {
        let name = ident(&field.name);
        if !field.optional {
            return arm(at, field, &quote!(required_into), &quote!(&mut self.#name, &mut keys));
        }
        let method = if manner == Manner::Strict { quote!(field_into) } else { quote!(status_field_into) };
        arm(at, field, &method, &quote!(&mut self.#name, &mut keys))
    });
    let ends = fields.iter().enumerate().map(|(at, field)| {
        let (name, at) = (ident(&field.name), Literal::usize_unsuffixed(at));
        if field.optional {
            return quote!(keys.absent(#at, &mut self.#name););
        }
        let (text, key) = (&field.name, &field.wire);
        quote!(keys.required(#at, #text, #key)?;)
    });
    let walk = walk_object(fields, arms, manner);
    quote! {
        #walk
        #(#ends)*
        Ok(())
    }
}

/// True for fields that can be read in place: their number and their types.
pub(crate) fn in_place(fields: &[Field]) -> bool {
    let is_plain = |field: &Field| truth_words(field).is_none() && !matches!(field.ty, Type::Python(_));
    fields.len() <= MAX_IN_PLACE && fields.iter().all(is_plain)
}

/// As many keys as `wire::Keys` can note.
const MAX_IN_PLACE: usize = 128;

/// Goes through an object, and leaves the value of each known key to its arm.
fn walk_object(fields: &[Field], arms: impl Iterator<Item = TokenStream>, manner: Manner) -> TokenStream {
    let keys = fields.iter().map(Field::key);
    let (begin, skip) = match manner {
        Manner::Strict => (quote!(begin_fields), quote!(skip())),
        Manner::Status | Manner::StatusSubset => (quote!(begin_status), quote!(skip_unknown(&keys))),
    };
    let next = manner.next();
    quote! {
        let mut keys = reader.#begin(&[#(#keys),*])?;
        while let Some(key) = reader.#next(&mut keys)? {
            match key {
                #(#arms)*
                _ => reader.#skip?,
            }
        }
    }
}

fn arm(at: usize, field: &Field, method: &TokenStream, slot: &TokenStream) -> TokenStream {
    let (at, read) = (Literal::usize_unsuffixed(at), read_call(field, method, slot));
    quote!(#at => #read?,)
}

/// The call that reads a field into a slot.
fn read_call(field: &Field, method: &TokenStream, slot: &TokenStream) -> TokenStream {
    let text = &field.name;
    let words = truth_words(field).map(|[off, on]| quote!(, #off, #on));
    quote!(reader.#method(#text, #slot #words))
}

fn read_method(field: &Field) -> TokenStream {
    match &field.ty {
        Type::Python(_) => quote!(field_python),
        _ if truth_words(field).is_some() => quote!(field_word),
        _ => quote!(field),
    }
}

/// The words of a truth value that is not read as usual.
fn truth_words(field: &Field) -> Option<[&str; 2]> {
    if let Type::Scalar(scalar) = &field.ty { scalar.truth_words() } else { None }
}

/// Statements and an expression that read the elements of an array that has been entered.
pub(crate) fn read_array(fields: &[Field], exact: bool, constructor: &TokenStream) -> TokenStream {
    let values = fields.iter().map(|field| {
        let (text, name) = (&field.name, ident(&field.name));
        let method = if field.optional { quote!(optional_element) } else { quote!(element) };
        quote!(#name: reader.#method(#text)?)
    });
    let end = end_array(exact);
    quote! {
        let this = #constructor { #(#values),* };
        #end?;
        Ok(this)
    }
}

/// Statements and an expression that read an array into the fields that `slot` names, and reuse their memory.
pub(crate) fn read_array_in_place(fields: &[Field], exact: bool, slot: impl Fn(&Ident) -> TokenStream) -> TokenStream {
    let values = fields.iter().map(|field| {
        let (text, slot) = (&field.name, slot(&ident(&field.name)));
        let method = if field.optional { quote!(optional_element_into) } else { quote!(element_into) };
        quote!(reader.#method(#text, #slot)?;)
    });
    let end = end_array(exact);
    quote! {
        #(#values)*
        #end
    }
}

fn end_array(exact: bool) -> TokenStream {
    if exact { quote!(reader.end_exact_array()) } else { quote!(reader.end_array()) }
}

/// The method that reads a value in place.
pub(crate) fn decode_into(statements: &TokenStream) -> TokenStream {
    quote! {
        fn decode_into(&mut self, reader: &mut wire::Reader<'_>) -> Result<(), wire::DecodeError> { #statements }
    }
}
