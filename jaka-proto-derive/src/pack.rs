//! The module of a pack: the additions of a user's TOML file to the built-in spec, in the user's crate.

use std::path::{Path, PathBuf};

use jaka_spec::{Command, Errors, Field, FieldSource, Module, NeededSource, Pack, Source, Spec, Topic, to_camel};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{LitStr, Token, parenthesized};

use crate::client::Method;
use crate::docs::{self, Docs, Place};
use crate::scope::{ModulePaths, Scope, ident};
use crate::{error_codes, events, topic};

/// Input of the macro from `jaka_sync::pack!`: the path of jaka-sync, the path of the TOML file, and the paths of the
/// packs on which it builds.
pub(crate) struct PackInput {
    sync: TokenStream,
    path: LitStr,
    lower: Punctuated<LitStr, Token![,]>,
}

impl Parse for PackInput {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let sync;
        parenthesized!(sync in input);
        let (sync, path) = (sync.parse()?, input.parse()?);
        if input.is_empty() {
            return Ok(Self { sync, path, lower: Punctuated::new() });
        }
        let word: Ident = input.parse()?;
        if word != "on" {
            return Err(syn::Error::new(word.span(), "expected `on` and the packs on which this one stands"));
        }
        Ok(Self { sync, path, lower: Punctuated::parse_separated_nonempty(input)? })
    }
}

/// The pack's module, or a compiler error for each thing that is wrong with it.
pub(crate) fn expand(input: &PackInput) -> TokenStream {
    let PackInput { sync, path, lower } = input;
    let rendered = match jaka_spec::builtin() {
        Ok(built_in) => {
            rendered(&built_in, input).map_or_else(|errors| errors, |module| render(&module, &built_in, sync))
        }
        Err(errors) => compile_errors(path.span(), &errors),
    };
    // Names the files to the compiler, so that an edit of one rebuilds the crate.
    let files = lower.iter().chain([path]).map(|path| folder().join(path.value())).filter(|file| file.is_file());
    let files = files.map(|file| file.display().to_string());
    quote! {
        #rendered
        #(const _: &[::core::primitive::u8] = ::core::include_bytes!(#files);)*
    }
}

/// The module, on top of the modules of other packs.
fn rendered(built_in: &Spec, input: &PackInput) -> Result<Module, TokenStream> {
    let mut spec = built_in.clone();
    for path in &input.lower {
        spec = load(&spec, path)?.module().spec;
    }
    let pack = load(&spec, &input.path)?;
    if pack.module_errors.is_empty() {
        return Ok(pack.module());
    }
    let errors = pack.module_errors.iter();
    Err(errors.map(|error| compile_error(input.path.span(), &error.to_string())).collect())
}

fn load(spec: &Spec, path: &LitStr) -> Result<Pack, TokenStream> {
    let relative = path.value();
    let file = folder().join(&relative);
    let text = jaka_spec::read_text(&file).map_err(|error| {
        let message = format!(
            "cannot read the pack `{}`: {error}; the path is relative to the folder of the crate's Cargo.toml",
            file.display()
        );
        compile_error(path.span(), &message)
    })?;
    let loaded = jaka_spec::load_pack(spec, Source { path: &relative, text: &text });
    loaded.map_err(|errors| compile_errors(path.span(), &errors))
}

/// The folder of the user's crate.
fn folder() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| Path::new(".").to_owned(), PathBuf::from)
}

fn compile_error(span: Span, message: &str) -> TokenStream {
    quote_spanned!(span=> ::core::compile_error!(#message);)
}

fn compile_errors(span: Span, errors: &Errors) -> TokenStream {
    errors.iter().map(|error| compile_error(span, &error.to_string())).collect()
}

/// The module: messages, error codes, and a trait with the methods.
pub(crate) fn render(module: &Module, built_in: &Spec, sync: &TokenStream) -> TokenStream {
    let topic = &module.topic;
    let name = ident(&topic.name);
    let docs = Docs::new(&module.spec, Place::Pack(module));
    let paths = ModulePaths::new(sync.clone());
    let scope = Scope { docs, ..Scope::of_module(&module.spec, topic, &paths) };
    let items = topic::items(scope, topic, &module.spec.sent_types());
    let covered = covered(module, scope);
    let status = motion_status(module, built_in, sync);
    let methods = methods(module, scope, sync);
    let codes = error_codes::in_pack(docs, &module.codes);
    let events = events::in_pack(&module.spec, &module.events);
    let docs = docs.topic(topic);
    quote! {
        #[allow(unreachable_pub, dead_code, clippy::self_named_constructors)]
        pub mod #name {
            #docs

            #[allow(unused_imports)]
            use #sync::proto::{self as proto, check, wire};

            #items
            #covered
            #status
            #methods
            #codes
            #events
        }
    }
}

/// Re-exports of the items that the spec has by now as the pack has them, under the names that the pack's user knows.
fn covered(module: &Module, scope: Scope<'_>) -> TokenStream {
    let mut items = Vec::new();
    for topic in &module.spec.topics {
        let path = scope.module(topic);
        let types = module.spec.types_of(topic).filter(|(id, _)| module.covered_types.contains(id));
        items.extend(types.map(|(_, def)| reexport(&path, &def.name, &def.name)));
        for command in covered_commands(module, topic) {
            let request = to_camel(&module.covered_commands[&command.wire]);
            items.push(reexport(&path, &command.request_type(), &request));
            items.extend(command.reply_type().map(|reply| reexport(&path, &reply, &format!("{request}Reply"))));
        }
    }
    quote!(#(#items)*)
}

fn reexport(path: &TokenStream, name: &str, here: &str) -> TokenStream {
    let (name, here) = (ident(name), ident(here));
    if name == here { quote!(pub use #path #name;) } else { quote!(pub use #path #name as #here;) }
}

fn covered_commands<'m>(module: &'m Module, topic: &'m Topic) -> impl Iterator<Item = &'m Command> {
    topic.commands.iter().filter(|command| module.covered_commands.contains_key(&command.wire))
}

/// Implementation of `MotionStatus` for a changed status packet, by the pack's `[robot_status]`. Where that leaves a
/// field to the program, a method by which the program implements the trait.
fn motion_status(module: &Module, built_in: &Spec, sync: &TokenStream) -> Option<TokenStream> {
    let spec = &module.spec;
    spec.status_type().filter(|id| module.topic.types.contains(id))?;
    let is_packs = |field: &Field| {
        let topic = field.ty.named().and_then(|id| spec.topic_of(id));
        topic.is_some_and(|topic| topic.is_pack)
    };
    let same = built_in.status_fields().iter().filter_map(|known| Some((known, spec.status_field_as(known)?)));
    let (names, own): (Vec<_>, Vec<_>) = same
        .filter(|(_, field)| !is_packs(field))
        .map(|(known, field)| (ident(&known.name), ident(&field.name)))
        .unzip();
    let body = quote! {
        let mut status = #sync::status::RobotStatus::default();
        #(status.#names = ::core::clone::Clone::clone(&self.#own);)*
        status
    };
    let (mut expected, mut absent, mut of_program) = (Vec::new(), Vec::new(), Vec::new());
    for NeededSource { needed, source, is_changed } in spec.robot_status() {
        let name = needed.name;
        match source {
            FieldSource::Field(field) if is_changed => {
                let own = &field.name;
                expected.push(quote!([#name, #own]));
            }
            FieldSource::Field(_) => {}
            FieldSource::Absent => absent.push(name),
            FieldSource::Program => of_program.push(format!("`{name}`")),
        }
    }
    if !of_program.is_empty() {
        let docs = docs::own(&format!(
            "The packet in terms of the built-in type, without {}, which the pack leaves to the program: for its \
             `MotionStatus`.",
            of_program.join(", ")
        ));
        return Some(quote! {
            impl RobotStatus {
                #docs
                pub fn as_built_in(&self) -> #sync::status::RobotStatus {
                    #body
                }
            }
        });
    }
    let absent = (!absent.is_empty()).then(|| {
        quote! {
            fn absent() -> &'static [&'static ::core::primitive::str] {
                &[#(#absent),*]
            }
        }
    });
    Some(quote! {
        impl #sync::MotionStatus for RobotStatus {
            fn robot_status(&self) -> #sync::status::RobotStatus {
                #body
            }

            #absent

            fn expected() -> &'static [[&'static ::core::primitive::str; 2]] {
                &[#(#expected),*]
            }
        }
    })
}

/// A trait with a method for each command of the pack, for all that takes commands.
fn methods(module: &Module, scope: Scope<'_>, sync: &TokenStream) -> Option<TokenStream> {
    let covered = module.spec.topics.iter().flat_map(|topic| {
        let path = scope.module(topic);
        covered_commands(module, topic).map(move |command| (path.clone(), command))
    });
    let own = module.topic.commands.iter().map(|command| (TokenStream::new(), command));
    let commands: Vec<_> = own.chain(covered).collect();
    if commands.is_empty() {
        return None;
    }
    let methods = commands.iter().map(|(path, command)| {
        let Method { head, parameter, argument, reply } = Method::new(scope, path, command);
        let docs = scope.docs.method(command, "`Call::call`", |_| None);
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
