//! A module for each topic.

use jaka_spec::{Spec, Topic};
use proc_macro2::TokenStream;
use quote::quote;

use crate::codec::{ModulePaths, Scope, ident};
use crate::{command, docs, error_codes, events, literal, request, typedef};

/// All messages of the spec.
pub(crate) fn messages(spec: &Spec) -> TokenStream {
    let topics = spec.topics.iter().map(|topic| module(spec, topic));
    let request = request::render(spec);
    let codes = error_codes::render(spec);
    let events = events::render(spec);
    quote!(#(#topics)* #request #codes #events)
}

/// The module of one topic; nothing for a topic without types and commands.
pub(crate) fn module(spec: &Spec, topic: &Topic) -> Option<TokenStream> {
    if topic.types.is_empty() && topic.commands.is_empty() {
        return None;
    }
    let name = ident(&topic.name);
    let docs = docs::topic(topic);
    let paths = ModulePaths::new(quote!(super));
    let items = items(Scope::of_module(spec, topic, &paths), topic);
    let literals = literal::module(spec, topic, quote!(super::super));
    Some(quote! {
        #docs
        pub mod #name {
            #[allow(unused_imports)]
            use ::jaka_proto::{self as proto, check, wire};

            #items
            #literals
        }
    })
}

/// The messages of one topic, for a place where `proto`, `check` and `wire` are jaka-proto and its modules.
pub(crate) fn items(scope: Scope<'_>, topic: &Topic) -> TokenStream {
    let commands = topic.commands.iter().map(|command| command::render(scope, command));
    let types = scope.spec.types_of(topic).map(|def| typedef::render(scope, def));
    quote!(#(#commands)* #(#types)*)
}
