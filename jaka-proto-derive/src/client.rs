//! The methods of the client.

use jaka_spec::{Command, Field, Request, Spec, Topic, Type};
use proc_macro2::TokenStream;
use quote::quote;

use crate::codec::ident;
use crate::{docs, typedef};

/// An `impl Client` with a method for each command.
pub(crate) fn methods(spec: &Spec) -> TokenStream {
    let methods = spec.topics.iter().flat_map(|topic| {
        let render = move |command| method(spec, topic, command);
        topic.commands.iter().map(render)
    });
    quote! {
        impl Client {
            #(#methods)*
        }
    }
}

fn method(spec: &Spec, topic: &Topic, command: &Command) -> TokenStream {
    let name = ident(&command.name);
    let module = ident(&topic.name);
    let request = ident(&command.request_type());
    let request = quote!(::jaka_proto::messages::#module::#request);
    let reply = command.reply_type().map_or_else(
        || quote!(()),
        |reply| {
            let reply = ident(&reply);
            quote!(::jaka_proto::messages::#module::#reply)
        },
    );
    let (parameter, argument) = match &command.request {
        Request::Fields(fields) if fields.is_empty() => (TokenStream::new(), quote!(&#request)),
        Request::Fields(fields) if fields.len() == 1 => single(spec, &fields[0], &request),
        _ => (quote!(, request: &#request), quote!(request)),
    };
    let deprecated = command.deprecated.as_ref().map(|note| quote!(#[deprecated(note = #note)]));
    let alias = docs::alias(&command.wire, &command.name);
    let text = docs::request(command);
    let docs = docs::attributes(&format!("{text}\n\n# Errors\nAs [`call`](Self::call).{}", refusal(command)));
    quote! {
        #docs
        #alias
        #deprecated
        pub fn #name(&mut self #parameter) -> Result<#reply, Error> {
            self.call(#argument)
        }
    }
}

/// The parameter that stands for a request with one field, and the request made from it.
fn single(spec: &Spec, field: &Field, request: &TokenStream) -> (TokenStream, TokenStream) {
    let name = ident(&field.name);
    let (ty, value) = match &field.ty {
        Type::Text => (quote!(impl Into<String>), quote!(#name: #name.into())),
        Type::Float => (quote!(f64), quote!(#name)),
        Type::Int => (quote!(i64), quote!(#name)),
        Type::Named(ty) => {
            let path = named(spec, ty);
            if spec.type_def(ty).is_some_and(typedef::converts) {
                (quote!(impl Into<#path>), quote!(#name: #name.into()))
            } else {
                (path, quote!(#name))
            }
        }
        _ => return (quote!(, request: &#request), quote!(request)),
    };
    (quote!(, #name: #ty), quote!(&#request { #value }))
}

fn named(spec: &Spec, name: &str) -> TokenStream {
    let module = ident(spec.topic_of_type(name).map_or("", |topic| topic.name.as_str()));
    let name = ident(name);
    quote!(::jaka_proto::messages::#module::#name)
}

/// What the controller does where a requirement is not met.
fn refusal(command: &Command) -> String {
    match &command.refusal {
        _ if command.requires.is_empty() => String::new(),
        None => " In another state than the one it needs, expect a refusal.".to_owned(),
        Some(refusal) => format!(
            " In another state than the one it needs, the controller refuses with code {}, `{}`.",
            refusal.code, refusal.message
        ),
    }
}
