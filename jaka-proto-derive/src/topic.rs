//! A module for each topic.

use std::collections::BTreeSet;

use jaka_spec::{Spec, Topic, TypeId};
use proc_macro2::TokenStream;
use quote::quote;

use crate::scope::{ModulePaths, Scope, ident};
use crate::{command, error_codes, events, literal, request, typedef};

/// All messages of the spec.
pub(crate) fn messages(spec: &Spec) -> TokenStream {
    let sent = spec.sent_types();
    let topics = spec.topics.iter().filter(|topic| has_module(topic)).map(|topic| module(spec, topic, &sent));
    let request = request::render(spec);
    let codes = error_codes::render(spec);
    let events = events::render(spec);
    quote!(#(#topics)* #request #codes #events)
}

/// True for a topic that has a module.
pub(crate) fn has_module(topic: &Topic) -> bool {
    !topic.types.is_empty() || !topic.commands.is_empty()
}

/// The module of one topic; `sent` are the types that requests have.
pub(crate) fn module(spec: &Spec, topic: &Topic, sent: &BTreeSet<TypeId>) -> TokenStream {
    let name = ident(&topic.name);
    let paths = ModulePaths::new(quote!(super));
    let scope = Scope::of_module(spec, topic, &paths);
    let (docs, items) = (scope.docs.topic(topic), items(scope, topic, sent));
    let literals = literal::module(spec, topic, quote!(super::super));
    quote! {
        pub mod #name {
            #docs

            #[allow(unused_imports)]
            use ::jaka_proto::{self as proto, check, wire};

            #items
            #literals
        }
    }
}

/// The messages of one topic, for a place where `proto`, `check` and `wire` are jaka-proto and its modules.
pub(crate) fn items(scope: Scope<'_>, topic: &Topic, sent: &BTreeSet<TypeId>) -> TokenStream {
    let commands = topic.commands.iter().map(|command| command::render(scope, command));
    let types = scope.spec.types_of(topic).map(|def| typedef::render(scope, def, sent));
    quote!(#(#commands)* #(#types)*)
}
