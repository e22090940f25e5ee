#![doc = include_str!("../README.md")]
// The logo: `docs/logo.svg`.
#![doc(
    html_logo_url = "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 64 64'><rect width='64' height='64' rx='12' fill='%2314506b'/><g fill='none' stroke='%23fff' stroke-width='6' stroke-linecap='round' stroke-linejoin='round'><path d='M14 54h20M24 54V42L20 22 44 14V30'/></g><g fill='%23f5a623'><circle cx='24' cy='42' r='5'/><circle cx='20' cy='22' r='5'/><circle cx='44' cy='14' r='5'/></g><path d='M38 40v-6h12v6' fill='none' stroke='%23fff' stroke-width='4'/></svg>"
)]

use proc_macro::TokenStream;
use quote::quote;
use syn::parse::Nothing;

mod call;
mod choice;
mod client;
mod codec;
mod command;
mod construct;
mod docs;
mod enums;
mod error_codes;
mod events;
mod motion;
mod pack;
mod role;
mod scope;
mod status_subset;
mod topic;
mod typedef;
mod validate;
mod word_enums;

#[cfg(test)]
mod tests;

/// The messages of the built-in spec: a module for each topic, an enum over all requests, and the enums of their
/// meaning.
///
/// For use in `jaka-proto`: the output names its paths.
#[proc_macro]
pub fn messages(input: TokenStream) -> TokenStream {
    expand(input, |spec| {
        let (messages, enums) = (topic::messages(spec), word_enums::render());
        quote!(#messages #enums)
    })
}

/// An `impl Client` for each topic of the built-in spec, with a method for each command, and the topic's module, in
/// which requests link to their methods.
///
/// For use in `jaka-sync`: its type `Client` has a method `call`, and its root has these modules.
#[proc_macro]
pub fn client_methods(input: TokenStream) -> TokenStream {
    expand(input, |spec| {
        let (modules, methods) = (client::modules(spec), client::methods(spec));
        quote!(#modules #methods)
    })
}

/// The module of a pack, for `jaka_sync::pack!`.
#[proc_macro]
pub fn pack(input: TokenStream) -> TokenStream {
    match syn::parse::<pack::PackInput>(input) {
        Ok(input) => pack::expand(&input).into(),
        Err(error) => error.into_compile_error().into(),
    }
}

/// A struct with some fields of the status packet, for `jaka_sync::status_subset!`.
#[proc_macro]
pub fn status_subset(input: TokenStream) -> TokenStream {
    let expanded = syn::parse::<status_subset::SubsetInput>(input).and_then(|input| status_subset::expand(&input));
    expanded.unwrap_or_else(syn::Error::into_compile_error).into()
}

/// The pattern of the invisible characters that are not control characters, for `jaka_proto::text`.
#[proc_macro]
pub fn hidden_characters(_input: TokenStream) -> TokenStream {
    let ranges = jaka_spec::prose::HIDDEN.iter().map(|range| {
        let (first, last) = (range.start(), range.end());
        quote!(#first..=#last)
    });
    quote!(#(#ranges)|*).into()
}

fn expand(input: TokenStream, render: fn(&jaka_spec::Spec) -> proc_macro2::TokenStream) -> TokenStream {
    if let Err(error) = syn::parse::<Nothing>(input) {
        return error.into_compile_error().into();
    }
    match jaka_spec::builtin() {
        Ok(spec) => render(&spec).into(),
        Err(errors) => compile_errors(&errors).into(),
    }
}

/// One compiler error for each error of the spec.
fn compile_errors(errors: &jaka_spec::Errors) -> proc_macro2::TokenStream {
    let messages = errors.iter().map(ToString::to_string);
    quote!(#(::core::compile_error!(#messages);)*)
}
