//! A method for each command.

use jaka_spec::{Command, Spec};
use proc_macro2::TokenStream;
use quote::quote;

use crate::call::{Call, Parameter, parameter};
use crate::docs::{self, Docs, Place};
use crate::scope::{ModulePaths, Scope, ident};
use crate::{construct, topic};

/// The modules of the topics as jaka-sync has them: those of jaka-proto, where each request links to its method.
pub(crate) fn modules(spec: &Spec) -> TokenStream {
    let modules = spec.topics.iter().filter(|topic| topic::has_module(topic)).map(|topic| {
        let name = ident(&topic.name);
        let docs = Docs::new(spec, Place::Client).topic(topic);
        let requests = topic.commands.iter().map(|command| {
            // rustdoc joins it with the first paragraph of the request's own docs.
            let (method, request) = (&command.name, ident(&command.request_type()));
            let docs = docs::own(&format!("Sent by [`Client::{method}`](crate::Client::{method})."));
            quote!(#docs #[doc(inline)] pub use ::jaka_proto::messages::#name::#request;)
        });
        // By name: requests that a glob imports too, rustdoc would show without the docs above.
        let replies = topic.commands.iter().filter_map(Command::reply_type);
        let types = spec.types_of(topic).map(|(_, def)| def.name.clone());
        let others = replies.chain(types).map(|name| ident(&name));
        quote! {
            pub mod #name {
                #docs

                #(#requests)*
                #[doc(inline)]
                pub use ::jaka_proto::messages::#name::{#(#others),*};
            }
        }
    });
    quote!(#(#modules)*)
}

/// An `impl Client` for each topic, with a method for each of its commands.
pub(crate) fn methods(spec: &Spec) -> TokenStream {
    let docs = Docs::new(spec, Place::Client);
    let paths = ModulePaths { elsewhere: quote!(self), wire: quote!(::jaka_proto::wire) };
    let scope = Scope { spec, topic: None, paths: &paths, docs };
    let topics = spec.topics.iter().filter(|topic| !topic.commands.is_empty()).map(|topic| {
        let module = scope.module(topic);
        let methods = topic.commands.iter().map(|command| {
            let Method { head, parameter, argument, reply } = Method::new(scope, &module, command);
            let code = |message: &str| Call::new(spec, topic, command, message).map(|call| call.code());
            let docs = docs.method(command, "[`call`](Self::call)", code);
            let name = ident(&command.name);
            quote! {
                #docs
                #head
                #[inline]
                pub fn #name(&mut self #parameter) -> Result<#reply, Error> {
                    self.call(#argument)
                }
            }
        });
        let heading = docs.heading(topic);
        quote! {
            #heading
            impl Client {
                #(#methods)*
            }
        }
    });
    quote!(#(#topics)*)
}

/// The parts of a command's method.
pub(crate) struct Method {
    /// The attributes other than the docs.
    pub(crate) head: TokenStream,
    /// Tokens of the parameter list after `self`, from the comma on.
    pub(crate) parameter: TokenStream,
    /// A reference to the request.
    pub(crate) argument: TokenStream,
    /// The type of the reply.
    pub(crate) reply: TokenStream,
}

impl Method {
    /// The method of a command with messages in `module`, a path that ends in `::` or is empty.
    pub(crate) fn new(scope: Scope<'_>, module: &TokenStream, command: &Command) -> Self {
        let request = ident(&command.request_type());
        let request = quote!(#module #request);
        let reply = scope.reply_type(module, command);
        let (parameter, argument) = match parameter(&command.request) {
            Parameter::None => (TokenStream::new(), quote!(&#request::new())),
            Parameter::Value(field) => {
                let (name, (ty, _)) = (ident(&field.name), construct::argument(scope, field));
                (quote!(, #name: #ty), quote!(&#request::new(#name)))
            }
            Parameter::Request => (quote!(, request: &#request), quote!(request)),
        };
        let (alias, sdk) = (docs::alias(&command.wire, &command.name), docs::sdk_aliases(command));
        let deprecated = command.deprecated.as_ref().map(|note| quote!(#[deprecated(note = #note)]));
        Self { head: quote!(#alias #sdk #deprecated), parameter, argument, reply }
    }
}
