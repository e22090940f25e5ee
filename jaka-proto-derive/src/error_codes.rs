//! The error codes that sources name.

use jaka_spec::words::first_sentence;
use jaka_spec::{ErrorCode, Spec, to_screaming};
use proc_macro2::TokenStream;
use quote::quote;

use crate::docs::{Docs, Place};
use crate::scope::ident;

/// Constants of `ErrorCode`, with their meanings.
pub(crate) fn render(spec: &Spec) -> TokenStream {
    let codes: Vec<_> = spec.errors().collect();
    let consts = consts(Docs::new(spec, Place::Messages(None)), &codes, &quote!(Self));
    let meanings = meanings(&codes);
    quote! {
        impl ::jaka_proto::ErrorCode {
            #consts

            /// Meaning of the code in a sentence, from sources; `None` for a code that they do not name.
            pub fn meaning(self) -> Option<&'static str> {
                match self.0 {
                    #meanings
                    _ => None,
                }
            }
        }
    }
}

/// Constants for the codes that a pack adds, and a function for these and all others.
pub(crate) fn in_pack(docs: Docs<'_>, codes: &[ErrorCode]) -> Option<TokenStream> {
    let codes: Vec<_> = codes.iter().collect();
    let consts = consts(docs, &codes, &quote!(proto::ErrorCode));
    let meanings = meanings(&codes);
    (!codes.is_empty()).then(|| {
        quote! {
            #consts

            /// Meaning of a code in a sentence, from sources; `None` for a code that neither they nor this module name.
            pub fn meaning(code: proto::ErrorCode) -> Option<&'static str> {
                match code.0 {
                    #meanings
                    _ => code.meaning(),
                }
            }
        }
    })
}

fn consts(docs: Docs<'_>, codes: &[&ErrorCode], ty: &TokenStream) -> TokenStream {
    let consts = codes.iter().map(|code| {
        let (docs, name, wire) = (docs.attributes(&code.doc), ident(&to_screaming(&code.name)), code.wire);
        quote!(#docs pub const #name: #ty = #ty(#wire);)
    });
    quote!(#(#consts)*)
}

fn meanings(codes: &[&ErrorCode]) -> TokenStream {
    let arms = codes.iter().map(|code| {
        let (wire, meaning) = (code.wire, first_sentence(&code.doc).0);
        quote!(#wire => Some(#meaning),)
    });
    quote!(#(#arms)*)
}
