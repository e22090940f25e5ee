//! The enums whose values are words of the TOML files.

use jaka_spec::{Change, Effect, Requirement, Role, Severity, WordEnum, to_snake};
use proc_macro2::TokenStream;
use quote::quote;

use crate::scope::ident;

/// Variants of `Role` that single requests have, and commands without a role in the TOML files.
const FURTHER_ROLES: &[(&str, &str)] = &[
    ("Start", " Starts a motion or a program, or moves the arm otherwise."),
    ("LeaveServoMode", " Leaves servo mode."),
];

const FURTHER_SEVERITIES: &[(&str, &str)] =
    &[("Unknown", " The table does not have the event's code, as with newer firmware. It may be an error.")];

/// The enums of jaka-proto.
pub(crate) fn render() -> TokenStream {
    let enums = [
        (Effect::WORD_ENUM, &[][..]),
        (Role::WORD_ENUM, FURTHER_ROLES),
        (Change::WORD_ENUM, &[]),
        (Requirement::WORD_ENUM, &[]),
        (Severity::WORD_ENUM, FURTHER_SEVERITIES),
    ];
    enums.into_iter().map(|(words, further)| word_enum(&words, further)).collect()
}

fn word_enum(words: &WordEnum, further: &[(&str, &str)]) -> TokenStream {
    let (name, doc) = (ident(words.name), words.doc);
    let (mut variants, mut texts) = (Vec::new(), Vec::new());
    let of_spec = words.values.iter().map(|(variant, word, doc)| (*variant, (*word).to_owned(), *doc));
    let further = further.iter().map(|(variant, doc)| (*variant, to_snake(variant), *doc));
    for (variant, word, doc) in of_spec.chain(further) {
        let variant = ident(variant);
        variants.push(quote!(#[doc = #doc] #variant));
        texts.push(quote!(Self::#variant => #word));
    }
    quote! {
        #(#[doc = #doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum #name { #(#variants),* }

        /// The word of the spec's files.
        impl ::core::fmt::Display for #name {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                f.pad(match self { #(#texts),* })
            }
        }
    }
}
