//! A module for each topic.

use std::collections::BTreeSet;

use jaka_spec::{Spec, Topic, TypeId};
use proc_macro2::TokenStream;
use quote::quote;

use crate::scope::{ModulePaths, Scope, ident};
use crate::{command, error_codes, events, typedef};

/// All messages of the spec.
pub(crate) fn messages(spec: &Spec) -> TokenStream {
    let sent = spec.sent_types();
    let topics = spec.topics.iter().filter(|topic| has_module(topic)).map(|topic| module(spec, topic, &sent));
    let request = requests(spec);
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
    quote! {
        pub mod #name {
            #docs

            #[allow(unused_imports)]
            use ::jaka_proto::{self as proto, check, wire};

            #items
        }
    }
}

/// The messages of one topic, for a place where `proto`, `check` and `wire` are jaka-proto and its modules.
pub(crate) fn items(scope: Scope<'_>, topic: &Topic, sent: &BTreeSet<TypeId>) -> TokenStream {
    let commands = topic.commands.iter().map(|command| command::render(scope, command));
    let types = scope.spec.types_of(topic).map(|def| typedef::render(scope, def, sent));
    quote!(#(#commands)* #(#types)*)
}

/// `Request`, with a variant for each command.
pub(crate) fn requests(spec: &Spec) -> TokenStream {
    let commands = spec.topics.iter().flat_map(|topic| topic.commands.iter().map(move |command| (topic, command)));
    let (mut names, mut modules, mut docs, mut wires) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (topic, command) in commands {
        names.push(ident(&command.request_type()));
        modules.push(ident(&topic.name));
        docs.push(format!(" `{}`", command.wire));
        wires.push(&command.wire);
    }
    quote! {
        /// Any request of the spec, by its `cmdName`.
        #[derive(Debug, Clone, PartialEq)]
        #[non_exhaustive]
        pub enum Request {
            #(#[doc = #docs] #names(#modules::#names)),*
        }

        impl Request {
            /// Facts of the spec about each command, topic by topic.
            pub const COMMANDS: &'static [&'static ::jaka_proto::CommandInfo] =
                &[#(<#modules::#names as ::jaka_proto::Command>::INFO),*];

            /// Does something with the request, whatever its type.
            pub fn visit<V: ::jaka_proto::Visit>(&self, visitor: V) -> V::Output {
                match self {
                    #(Self::#names(request) => visitor.visit(request)),*
                }
            }

            /// Reads the request `name` from its JSON; `None` if the spec has no such command.
            #[inline]
            pub(crate) fn read_named(
                name: &str,
                reader: &mut ::jaka_proto::wire::Reader<'_>,
            ) -> Option<Result<Self, ::jaka_proto::wire::DecodeError>> {
                Some(match name {
                    #(#wires => ::jaka_proto::wire::Fields::read_fields(reader).map(Self::#names),)*
                    _ => return None,
                })
            }
        }

        #(
            impl From<#modules::#names> for Request {
                fn from(request: #modules::#names) -> Self {
                    Self::#names(request)
                }
            }
        )*
    }
}
