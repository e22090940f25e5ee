//! Scope of generated code: its topic, and the paths and docs that follow from it.

use jaka_spec::{Command, Field, Reply, Scalar, Spec, Topic, Type, TypeId};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::docs::{Docs, Place};

/// Scope of generated code. It decides the names of types in the code: types of its own topic have their plain name,
/// others the path of their topic's module.
#[derive(Clone, Copy)]
pub(crate) struct Scope<'s> {
    pub(crate) spec: &'s Spec,
    /// The topic whose module it is; none outside of all of them.
    pub(crate) topic: Option<&'s Topic>,
    pub(crate) paths: &'s ModulePaths,
    /// Place of its docs, which decides the items that their links lead to.
    pub(crate) docs: Docs<'s>,
}

impl<'s> Scope<'s> {
    /// The scope of a topic's module, where `proto`, `check` and `wire` are jaka-proto and its modules.
    pub(crate) fn of_module(spec: &'s Spec, topic: &'s Topic, paths: &'s ModulePaths) -> Self {
        let docs = Docs::new(spec, Place::Messages(Some(topic)));
        Self { spec, topic: Some(topic), paths, docs }
    }

    /// The Rust type, as named from inside the topic's module.
    pub(crate) fn rust_type(self, ty: &Type) -> TokenStream {
        match ty {
            Type::Scalar(Scalar::Bool { .. }) => quote!(bool),
            Type::Scalar(Scalar::Int) => quote!(i64),
            Type::Scalar(Scalar::Float) => quote!(f64),
            Type::Scalar(Scalar::Text) => quote!(String),
            Type::Scalar(Scalar::Json) => {
                let wire = &self.paths.wire;
                quote!(#wire::Value)
            }
            Type::Python(inner) => self.rust_type(inner),
            Type::List(element) => {
                let element = self.rust_type(element);
                quote!(Vec<#element>)
            }
            Type::Array(element, len) => {
                let (element, len) = (self.rust_type(element), Literal::usize_unsuffixed(*len));
                quote!([#element; #len])
            }
            Type::Named(id) => self.path(*id),
        }
    }

    /// Attribute of the functions that read the topic's types. The functions for the status packet are compiled here,
    /// since most programs read it; those for other types are `#[inline]` and compiled in the programs that use them.
    pub(crate) fn inline_reads(self) -> Option<TokenStream> {
        let status = self.spec.status_type();
        let has_status = self.topic.is_some_and(|topic| status.is_some_and(|status| topic.types.contains(&status)));
        (!has_status).then(|| quote!(#[inline]))
    }

    /// The path of a named type.
    pub(crate) fn path(self, id: TypeId) -> TokenStream {
        let is_own = self.topic.is_some_and(|topic| topic.types.contains(&id));
        let topic = self.spec.topic_of(id).filter(|_| !is_own);
        let module = topic.map(|topic| self.module(topic));
        let name = ident(&self.spec[id].name);
        quote!(#module #name)
    }

    /// The type of a command's reply, where `module`, a path that ends in `::` or is empty, has the command's messages.
    pub(crate) fn reply_type(self, module: &TokenStream, command: &Command) -> TokenStream {
        match (&command.reply, command.reply_type()) {
            (Reply::Object(id), _) => self.path(*id),
            (Reply::Fields(_), Some(name)) => {
                let name = ident(&name);
                quote!(#module #name)
            }
            (Reply::Fields(_), None) => quote!(()),
            (Reply::Raw, _) => self.rust_type(&Type::Scalar(Scalar::Json)),
        }
    }

    /// The path of another topic's module.
    pub(crate) fn module(self, topic: &Topic) -> TokenStream {
        let (module, elsewhere) = (ident(&topic.name), &self.paths.elsewhere);
        // The modules of packs stand next to each other.
        if topic.is_pack { quote!(super::#module::) } else { quote!(#elsewhere::#module::) }
    }

    /// The type of a struct's field.
    pub(crate) fn field_type(self, field: &Field) -> TokenStream {
        let ty = self.required_type(field);
        if field.optional { quote!(Option<#ty>) } else { ty }
    }

    /// The type of a field's value, without `Option`.
    pub(crate) fn required_type(self, field: &Field) -> TokenStream {
        let ty = self.rust_type(&field.ty);
        if !field.or_raw {
            return ty;
        }
        let wire = &self.paths.wire;
        quote!(#wire::Typed<#ty>)
    }

    /// `name: type` for each field, with docs; `vis` precedes each.
    pub(crate) fn declare(self, fields: &[Field], vis: &TokenStream) -> TokenStream {
        let fields = fields.iter().map(|field| {
            let docs = self.docs.field(fields, field);
            let name = ident(&field.name);
            let ty = self.field_type(field);
            quote!(#docs #vis #name: #ty)
        });
        quote!(#(#fields),*)
    }
}

/// The paths that generated code uses.
pub(crate) struct ModulePaths {
    /// The path of the module that has the other topics' modules.
    pub(crate) elsewhere: TokenStream,
    /// The path of the module `wire`.
    pub(crate) wire: TokenStream,
}

impl ModulePaths {
    /// Paths for code in the module itself; `elsewhere` has the other topics' modules.
    pub(crate) fn new(elsewhere: TokenStream) -> Self {
        Self { elsewhere, wire: quote!(wire) }
    }
}

pub(crate) fn ident(name: &str) -> Ident {
    format_ident!("{name}")
}

/// The names of the fields, to destructure or construct with.
pub(crate) fn names(fields: &[Field]) -> Vec<Ident> {
    fields.iter().map(|field| ident(&field.name)).collect()
}
