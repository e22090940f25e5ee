//! Twins of replies and of their parts, which can be written as literals: for the simulator and for tests.

use jaka_spec::{Spec, Topic, TypeDef, TypeKind};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::construct;
use crate::scope::{ModulePaths, Scope, ident, names};

/// The module with the twins of a topic; nothing without any. `elsewhere` has the modules of the other topics.
pub(crate) fn module(spec: &Spec, topic: &Topic, elsewhere: TokenStream) -> Option<TokenStream> {
    let paths = ModulePaths::inner(elsewhere);
    let scope = Scope::of_module(spec, topic, &paths);
    let replies = topic.commands.iter().filter_map(|command| {
        let name = ident(&command.reply_type()?);
        Some(object(scope, &name, command.reply.own_fields()))
    });
    let types = spec.types_of(topic).filter_map(|(_, def)| type_def(scope, def));
    let twins: Vec<_> = replies.chain(types).collect();
    (!twins.is_empty()).then(|| {
        quote! {
            /// Replies and their parts, as structs that can be written as literals. The structs grow with the spec, so
            /// that the compiler reports each literal that lacks a field. They are not part of the interface.
            #[doc(hidden)]
            #[allow(missing_docs, missing_debug_implementations, clippy::too_many_lines)]
            pub mod literal {
                #(#twins)*
            }
        }
    })
}

fn type_def(scope: Scope<'_>, def: &TypeDef) -> Option<TokenStream> {
    let name = ident(&def.name);
    match &def.kind {
        TypeKind::Object(fields) => Some(object(scope, &name, fields)),
        TypeKind::Array { fields, .. } if !construct::converts(def) => Some(object(scope, &name, fields)),
        TypeKind::Choice(choice) => Some(self::choice(scope, &name, choice)),
        TypeKind::Array { .. } | TypeKind::IntEnum(_) | TypeKind::TextEnum(_) | TypeKind::Wrapper(..) => None,
    }
}

fn object(scope: Scope<'_>, name: &Ident, fields: &[jaka_spec::Field]) -> TokenStream {
    let types = fields.iter().map(|field| scope.field_type(field));
    let names = names(fields);
    quote! {
        pub struct #name { #(pub #names: #types),* }

        impl From<#name> for super::#name {
            #[inline]
            fn from(#name { #(#names),* }: #name) -> Self {
                Self { #(#names),* }
            }
        }
    }
}

fn choice(scope: Scope<'_>, name: &Ident, choice: &jaka_spec::Choice) -> TokenStream {
    let declared = choice.variants.iter().map(|variant| {
        let (path, names) = (ident(&variant.name), names(&variant.fields));
        let types = variant.fields.iter().map(|field| scope.field_type(field));
        quote!(#path { #(#names: #types),* })
    });
    let arms = choice.variants.iter().map(|variant| {
        let (path, names) = (ident(&variant.name), names(&variant.fields));
        quote!(#name::#path { #(#names),* } => Self::#path { #(#names),* },)
    });
    quote! {
        pub enum #name { #(#declared),* }

        impl From<#name> for super::#name {
            #[inline]
            fn from(value: #name) -> Self {
                match value { #(#arms)* }
            }
        }
    }
}
