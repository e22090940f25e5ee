//! A module for each topic.

use jaka_spec::Spec;
use proc_macro2::TokenStream;
use quote::quote;

use crate::codec::{Scope, ident};
use crate::{command, docs, error_codes, request, typedef};

/// All messages of the spec.
pub(crate) fn messages(spec: &Spec) -> TokenStream {
    let topics = spec.topics.iter().map(|topic| module(Scope { spec, topic }));
    let request = request::render(spec);
    let codes = error_codes::render(spec);
    quote!(#(#topics)* #request #codes)
}

/// The module of one topic; nothing for a topic without types and commands.
pub(crate) fn module(scope: Scope<'_>) -> Option<TokenStream> {
    let topic = scope.topic;
    if topic.types.is_empty() && topic.commands.is_empty() {
        return None;
    }
    let name = ident(&topic.name);
    let docs = docs::attributes(&format!("{}.\n\n{}", topic.title, topic.doc));
    let commands = topic.commands.iter().map(|command| command::render(scope, command));
    let types = topic.types.iter().map(|def| typedef::render(scope, def));
    Some(quote! {
        #docs
        pub mod #name {
            #[allow(unused_imports)]
            use ::jaka_proto::{check, wire};

            #(#commands)*
            #(#types)*
        }
    })
}
