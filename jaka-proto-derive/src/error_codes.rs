//! The error codes that sources name.

use jaka_spec::words::first_sentence;
use jaka_spec::{ErrorCode, Spec, to_screaming};
use proc_macro2::TokenStream;
use quote::quote;

use crate::codec::ident;
use crate::docs;

/// Constants of `ErrorCode`, and what each means.
pub(crate) fn render(spec: &Spec) -> TokenStream {
    let consts = spec.errors().map(|code| {
        let docs = docs::attributes(&code.doc);
        let name = ident(&to_screaming(&code.name));
        let wire = code.wire;
        quote!(#docs pub const #name: Self = Self(#wire);)
    });
    let wires = spec.errors().map(|code| code.wire);
    let meanings = spec.errors().map(|code| first_sentence(&code.doc).0);
    quote! {
        impl ::jaka_proto::ErrorCode {
            #(#consts)*

            /// What sources say about the code, in a sentence; `None` for a code they do not name.
            pub fn meaning(self) -> Option<&'static str> {
                match self.0 {
                    #(#wires => Some(#meanings),)*
                    _ => None,
                }
            }
        }
    }
}

/// Constants for the codes that a pack adds, and a function that knows them beside all others.
pub(crate) fn in_pack(codes: &[ErrorCode]) -> Option<TokenStream> {
    let consts = codes.iter().map(|code| {
        let docs = docs::attributes(&code.doc);
        let name = ident(&to_screaming(&code.name));
        let wire = code.wire;
        quote!(#docs pub const #name: proto::ErrorCode = proto::ErrorCode(#wire);)
    });
    let wires = codes.iter().map(|code| code.wire);
    let meanings = codes.iter().map(|code| first_sentence(&code.doc).0);
    (!codes.is_empty()).then(|| {
        quote! {
            #(#consts)*

            /// What sources say about a code, in a sentence; `None` for a code that neither they nor this module name.
            pub fn meaning(code: proto::ErrorCode) -> Option<&'static str> {
                match code.0 {
                    #(#wires => Some(#meanings),)*
                    _ => code.meaning(),
                }
            }
        }
    })
}
