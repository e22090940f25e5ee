//! Values: how they are written.

use jaka_spec::{Scalar, Type};
use proc_macro2::TokenStream;
use quote::quote;

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
