//! The module of a pack: what a user's TOML file adds to the built-in spec, in the user's crate.

use std::path::{Path, PathBuf};

use jaka_spec::{Command, Error, Module, Pack, Source, Topic};
use proc_macro2::{Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::parse::{Parse, ParseStream};
use syn::{LitStr, parenthesized};

use crate::client::Method;
use crate::docs::{self, Docs, Place};
use crate::scope::{ModulePaths, Scope, ident};
use crate::{error_codes, events, literal, topic};

/// What `jaka_sync::pack!` hands over: the path of jaka-sync, and that of the TOML file.
pub(crate) struct Input {
    sync: TokenStream,
    path: LitStr,
}

impl Parse for Input {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let sync;
        parenthesized!(sync in input);
        Ok(Self { sync: sync.parse()?, path: input.parse()? })
    }
}

/// The pack's module, or a compiler error for each thing that is wrong with it.
pub(crate) fn expand(input: &Input) -> TokenStream {
    let Input { sync, path } = input;
    let relative = path.value();
    let file = folder().join(&relative);
    let text = match std::fs::read_to_string(&file) {
        Ok(text) => text,
        Err(error) => {
            let message = format!(
                "cannot read the pack `{}`: {error}; the path is relative to the folder of the crate's Cargo.toml",
                file.display()
            );
            return compile_error(path.span(), &message);
        }
    };
    let source = Source { path: &relative, text: &text };
    let loaded = jaka_spec::builtin().and_then(|spec| jaka_spec::load_pack(&spec, source));
    let rendered = match loaded {
        Ok(pack) => {
            let notes = notes(&pack, path.span());
            let module = module(&pack.module(), sync);
            quote!(#module #notes)
        }
        Err(errors) => errors.iter().map(|error| compile_error(path.span(), &error.to_string())).collect(),
    };
    // Names the file to the compiler, so that an edit of it rebuilds the crate.
    let rebuild = file.display().to_string();
    quote! {
        #rendered
        const _: &[::core::primitive::u8] = ::core::include_bytes!(#rebuild);
    }
}

/// The folder of the user's crate.
fn folder() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| Path::new(".").to_owned(), PathBuf::from)
}

fn compile_error(span: Span, message: &str) -> TokenStream {
    quote_spanned!(span=> ::core::compile_error!(#message);)
}

/// A warning for each note: the use of a constant that is deprecated for that reason.
fn notes(pack: &Pack, span: Span) -> TokenStream {
    let warning = |note: &Error| {
        let text = note.to_string();
        quote_spanned! {span=>
            const _: () = {
                #[deprecated(note = #text)]
                const PACK: () = ();
                PACK
            };
        }
    };
    pack.notes.iter().map(warning).collect()
}

/// The module: messages, error codes, and a trait with the methods.
pub(crate) fn module(module: &Module, sync: &TokenStream) -> TokenStream {
    let topic = &module.topic;
    let name = ident(&topic.name);
    let docs = Docs::new(&module.spec, Place::Pack(module));
    let paths = ModulePaths::new(sync.clone());
    let scope = Scope { docs, ..Scope::of_module(&module.spec, topic, &paths) };
    let items = topic::items(scope, topic, &module.spec.sent_types());
    let literals = literal::module(&module.spec, topic, sync.clone());
    let repeated = repeated(module, scope);
    let methods = methods(module, scope, sync);
    let codes = error_codes::in_pack(docs, &topic.errors);
    let events = events::in_pack(&topic.events);
    let docs = docs.topic(topic);
    quote! {
        #[allow(unreachable_pub, dead_code, clippy::self_named_constructors)]
        pub mod #name {
            #docs

            #[allow(unused_imports)]
            use #sync::proto::{self as proto, check, wire};

            #items
            #literals
            #repeated
            #methods
            #codes
            #events
        }
    }
}

/// What the pack repeats as the spec has it, under the names that the pack's user knows.
fn repeated(module: &Module, scope: Scope<'_>) -> TokenStream {
    let mut items = Vec::new();
    for topic in &module.spec.topics {
        let path = scope.module(topic);
        let types = module.spec.types_of(topic).filter(|(id, _)| module.repeated_types.contains(id));
        let commands = repeated_commands(module, topic);
        let messages = commands.flat_map(|command| [Some(command.request_type()), command.reply_type()]).flatten();
        for name in types.map(|(_, def)| def.name.clone()).chain(messages) {
            let name = ident(&name);
            items.push(quote!(pub use #path #name;));
        }
    }
    quote!(#(#items)*)
}

fn repeated_commands<'m>(module: &'m Module, topic: &'m Topic) -> impl Iterator<Item = &'m Command> {
    topic.commands.iter().filter(|command| module.repeated_commands.contains(&command.wire))
}

/// A trait with a method for each command of the pack, for all that takes commands.
fn methods(module: &Module, scope: Scope<'_>, sync: &TokenStream) -> Option<TokenStream> {
    let commands = module.spec.topics.iter().flat_map(|topic| repeated_commands(module, topic));
    let commands: Vec<_> = module.topic.commands.iter().chain(commands).collect();
    if commands.is_empty() {
        return None;
    }
    let methods = commands.iter().map(|command| {
        let Method { head, parameter, argument, reply } = Method::new(scope, &TokenStream::new(), command);
        let docs = scope.docs.method(command, "`Call::call`");
        let name = ident(&module.method(command));
        quote! {
            #docs
            #head
            fn #name(&mut self #parameter) -> Result<#reply, #sync::Error> {
                #sync::Call::call(self, #argument)
            }
        }
    });
    let name = ident(&module.trait_name());
    let docs = docs::own(&format!(
        "The commands of [`{}`](self) as methods: of a client, of a robot, and of all else that takes commands.",
        module.topic.name
    ));
    Some(quote! {
        #docs
        pub trait #name: #sync::Call {
            #(#methods)*
        }

        impl<T: #sync::Call + ?Sized> #name for T {}
    })
}
