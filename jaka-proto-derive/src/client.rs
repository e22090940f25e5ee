//! A method for each command.

use jaka_spec::{Command, Field, Request, Scalar, Spec, Type};
use proc_macro2::TokenStream;
use quote::quote;

use crate::codec::{Scope, ident};
use crate::{docs, typedef};

/// An `impl Client` with a method for each command.
pub(crate) fn methods(spec: &Spec) -> TokenStream {
    let messages = quote!(::jaka_proto::messages);
    let scope = Scope { spec, topic: None, elsewhere: &messages, wire: &quote!(wire) };
    let methods = spec.topics.iter().flat_map(|topic| {
        let module = scope.module(topic);
        topic.commands.iter().map(move |command| {
            let Method { head, parameter, argument, reply } = Method::new(scope, &module, command);
            let docs = docs::method(command, "[`call`](Self::call)");
            let name = ident(&command.name);
            quote! {
                #docs
                #head
                pub fn #name(&mut self #parameter) -> Result<#reply, Error> {
                    self.call(#argument)
                }
            }
        })
    });
    quote! {
        impl Client {
            #(#methods)*
        }
    }
}

/// The parts of a command's method.
pub(crate) struct Method {
    /// The attributes beside the docs.
    pub(crate) head: TokenStream,
    /// What follows `self`, from the comma on.
    pub(crate) parameter: TokenStream,
    /// A reference to the request.
    pub(crate) argument: TokenStream,
    /// The type of the reply.
    pub(crate) reply: TokenStream,
}

impl Method {
    /// The method of a command whose messages stand in `module`, a path that ends in `::` or is empty.
    pub(crate) fn new(scope: Scope<'_>, module: &TokenStream, command: &Command) -> Self {
        let request = ident(&command.request_type());
        let request = quote!(#module #request);
        let reply = command.reply_type().map(|reply| ident(&reply));
        let reply = reply.map_or_else(|| quote!(()), |reply| quote!(#module #reply));
        let (parameter, argument) = match &command.request {
            Request::Fields(fields) if fields.is_empty() => (TokenStream::new(), quote!(&#request)),
            Request::Fields(fields) if fields.len() == 1 => single(scope, &fields[0], &request),
            _ => (quote!(, request: &#request), quote!(request)),
        };
        let alias = docs::alias(&command.wire, &command.name);
        let deprecated = command.deprecated.as_ref().map(|note| quote!(#[deprecated(note = #note)]));
        Self { head: quote!(#alias #deprecated), parameter, argument, reply }
    }
}

/// The parameter that stands for a request with one field, and the request made from it.
fn single(scope: Scope<'_>, field: &Field, request: &TokenStream) -> (TokenStream, TokenStream) {
    let name = ident(&field.name);
    let whole = (quote!(, request: &#request), quote!(request));
    if field.optional || field.or_raw {
        return whole;
    }
    let (ty, value) = match &field.ty {
        Type::Scalar(Scalar::Text) => (quote!(impl Into<String>), quote!(#name: #name.into())),
        Type::Scalar(Scalar::Float) => (quote!(f64), quote!(#name)),
        Type::Scalar(Scalar::Int) => (quote!(i64), quote!(#name)),
        Type::Named(id) => {
            let path = scope.path(*id);
            if typedef::converts(&scope.spec[*id]) {
                (quote!(impl Into<#path>), quote!(#name: #name.into()))
            } else {
                (path, quote!(#name))
            }
        }
        Type::Scalar(Scalar::Bool { .. } | Scalar::Json) | Type::List(_) | Type::Array(..) | Type::Python(_) => {
            return whole;
        }
    };
    (quote!(, #name: #ty), quote!(&#request { #value }))
}
