//! A struct with some fields of the status packet.

use jaka_spec::{Field, Spec, words};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Token, braced, bracketed, parenthesized};

use crate::codec::{Manner, in_place, read_object, read_object_in_place};
use crate::docs::{Docs, Place};
use crate::scope::{ModulePaths, Scope};

/// Input of the macro from `jaka_sync::status_subset!`: the path of jaka-sync, the tokens before `struct`, the name and
/// the fields.
pub(crate) struct SubsetInput {
    sync: TokenStream,
    head: TokenStream,
    name: Ident,
    fields: Punctuated<Ident, Token![,]>,
}

impl Parse for SubsetInput {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let (sync, head, fields);
        parenthesized!(sync in input);
        bracketed!(head in input);
        let (sync, head, name) = (sync.parse()?, head.parse()?, input.parse()?);
        braced!(fields in input);
        Ok(Self { sync, head, name, fields: Punctuated::parse_terminated(&fields)? })
    }
}

/// The struct and its reader, or an error at the first field that the status packet does not have.
pub(crate) fn expand(input: &SubsetInput) -> syn::Result<TokenStream> {
    let spec = jaka_spec::builtin().map_err(|errors| syn::Error::new(input.name.span(), errors))?;
    let fields = fields(&spec, input)?;
    let SubsetInput { sync, head, name, .. } = input;
    let wire = quote!(#sync::proto::wire);
    let docs = Docs::new(&spec, Place::User);
    let paths = ModulePaths { elsewhere: sync.clone(), wire: wire.clone() };
    let scope = Scope { spec: &spec, topic: None, paths: &paths, docs };
    let copy = spec.all_copy(&fields).then(|| quote!(Copy,));
    let declared = scope.declare(&fields, &quote!(pub));
    let read = if in_place(&fields) {
        read_object_in_place(&fields, Manner::StatusSubset)
    } else {
        let read = read_object(&fields, &quote!(Self), Manner::StatusSubset);
        quote!(*self = (|| -> Result<Self, wire::DecodeError> { #read })()?; Ok(()))
    };
    Ok(quote! {
        #[derive(Debug, Clone, #copy PartialEq, Default)]
        #[allow(unreachable_pub)]
        #head struct #name { #declared }

        const _: () = {
            use #wire;

            impl wire::Decode for #name {
                fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
                    let mut this = Self::default();
                    wire::Decode::decode_into(&mut this, reader)?;
                    Ok(this)
                }

                fn decode_into(&mut self, reader: &mut wire::Reader<'_>) -> Result<(), wire::DecodeError> { #read }
            }
        };
    })
}

/// The fields as the spec has them, in the order in which the user wrote them.
fn fields(spec: &Spec, input: &SubsetInput) -> syn::Result<Vec<Field>> {
    let all = spec.status_fields();
    let mut chosen: Vec<Field> = Vec::new();
    for name in &input.fields {
        let field = all.iter().find(|field| name == &field.name);
        let field = field.ok_or_else(|| syn::Error::new(name.span(), unknown(all, &name.to_string())))?;
        if chosen.contains(field) {
            return Err(syn::Error::new(name.span(), format!("`{name}` stands here twice")));
        }
        chosen.push(field.clone());
    }
    Ok(chosen)
}

fn unknown(all: &[Field], name: &str) -> String {
    if let Some(field) = all.iter().find(|field| field.wire == name) {
        return format!("`{name}` on the wire is `{}` here", field.name);
    }
    let near = words::nearest(name, all.iter().map(|field| field.name.as_str()));
    let near = near.map(|near| format!("; is it `{near}`?")).unwrap_or_default();
    format!("the status packet has no field `{name}`{near}")
}
