//! The enum over all requests.

use jaka_spec::Spec;
use proc_macro2::TokenStream;
use quote::quote;

use crate::scope::ident;

/// `Request`, with a variant for each command.
pub(crate) fn render(spec: &Spec) -> TokenStream {
    let commands = spec.topics.iter().flat_map(|topic| topic.commands.iter().map(move |command| (topic, command)));
    let (mut names, mut modules, mut docs, mut wires) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (topic, command) in commands {
        names.push(ident(&command.request_type()));
        modules.push(ident(&topic.name));
        docs.push(format!(" `{}`", command.wire));
        wires.push(&command.wire);
    }
    quote! {
        /// Any request of the spec, told apart by its `cmdName`.
        #[derive(Debug, Clone, PartialEq)]
        #[non_exhaustive]
        pub enum Request {
            #(#[doc = #docs] #names(#modules::#names)),*
        }

        impl Request {
            /// What the spec says about each command, topic by topic.
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
