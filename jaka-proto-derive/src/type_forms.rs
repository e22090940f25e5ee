//! Forms of types by firmware: how they are written and read.

use jaka_spec::{Factors, Field, Form, FormKind, TypeDef};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::codec::{Manner, read_array, read_object, write_all};
use crate::forms::{arms, elements, ranges};

/// The codec of an object that is an array in some firmware.
pub(crate) fn object(name: &Ident, def: &TypeDef, fields: &[Field]) -> TokenStream {
    let ranges = ranges(def.forms.iter().map(|form| &form.versions));
    let write = write_all(&elements(fields), |name| quote!(&self.#name));
    let read = read_array(fields, false, &quote!(Self));
    quote! {
        impl wire::Encode for #name {
            fn encode(&self, out: &mut wire::Writer) {
                if out.form(#ranges).is_some() {
                    out.raw("[");
                    #write
                    out.raw("]");
                } else {
                    out.raw("{");
                    wire::Fields::write_fields(self, out);
                    out.raw("}");
                }
            }
        }

        impl wire::Decode for #name {
            fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
                if reader.is_list() {
                    reader.begin_array()?;
                    #read
                } else {
                    wire::Fields::read_fields(reader)
                }
            }
        }

        proto::__serde_impls!(#name);
    }
}

/// The codec of an array that is an object in some firmware.
pub(crate) fn array(name: &Ident, def: &TypeDef, fields: &[Field], exact: bool) -> TokenStream {
    let ranges = ranges(def.forms.iter().map(|form| &form.versions));
    let own = write_all(fields, |name| quote!(&self.#name));
    let keys: Vec<_> = def.forms.iter().filter_map(|form| object_keys(&form.kind)).collect();
    let arms = arms(keys.iter().map(|keys| {
        let write = write_all(&members(fields, &[keys]), |name| quote!(&self.#name));
        quote!({ out.raw("{"); #write out.raw("}"); })
    }));
    let read = read_array(fields, exact, &quote!(Self));
    let read_members = read_object(&members(fields, &keys), &quote!(Self), Manner::Strict);
    quote! {
        impl wire::Encode for #name {
            fn encode(&self, out: &mut wire::Writer) {
                match out.form(#ranges) {
                    #arms
                    _ => {
                        out.raw("[");
                        #own
                        out.raw("]");
                    }
                }
            }
        }

        impl wire::Decode for #name {
            fn decode(reader: &mut wire::Reader<'_>) -> Result<Self, wire::DecodeError> {
                if reader.is_list() {
                    reader.begin_array()?;
                    #read
                } else {
                    #read_members
                }
            }
        }

        proto::__serde_impls!(#name);
    }
}

fn object_keys(kind: &FormKind) -> Option<&Vec<String>> {
    match kind {
        FormKind::Object(keys) => Some(keys),
        FormKind::Array | FormKind::Unit { .. } => None,
    }
}

/// The elements of an array as fields of an object, under the keys of each of its forms.
fn members(fields: &[Field], keys: &[&Vec<String>]) -> Vec<Field> {
    let member = |(at, field): (usize, &Field)| {
        let mut names = keys.iter().filter_map(|keys| keys.get(at));
        let mut member = Field { wire: names.next().cloned().unwrap_or_default(), ..field.clone() };
        member.forms.iter_mut().for_each(|form| form.wire.clone_from(&member.wire));
        let own = member.own_form();
        member
            .forms
            .extend(names.filter(|name| **name != own.wire).map(|name| Form { wire: name.clone(), ..own.clone() }));
        member
    };
    fields.iter().enumerate().map(member).collect()
}

/// Statements that write, and an expression that reads, a wrapped value in the unit of the firmware.
pub(crate) fn wrapped(def: &TypeDef, write: &TokenStream) -> (TokenStream, TokenStream) {
    let ranges = ranges(def.forms.iter().map(|form| &form.versions));
    let factors: Vec<_> = def.forms.iter().map(|form| unit_factors(&form.kind)).collect();
    let reads = arms(factors.iter().map(|factors| {
        let factor = Literal::f64_unsuffixed(factors.from);
        quote!(wire::Scaled::times(&value, #factor))
    }));
    let writes = arms(factors.iter().map(|factors| {
        let factor = Literal::f64_unsuffixed(factors.to);
        quote!(wire::Encode::encode(&wire::Scaled::times(&self.0, #factor), out))
    }));
    let write = quote!(match out.form(#ranges) { #writes _ => { #write } });
    let read = quote! {{
        let form = reader.form(#ranges)?;
        let value = wire::Decode::decode(reader)?;
        Ok(Self(match form { #reads _ => value }))
    }};
    (write, read)
}

fn unit_factors(kind: &FormKind) -> Factors {
    match kind {
        FormKind::Unit { factors, .. } => *factors,
        FormKind::Object(_) | FormKind::Array => Factors::ONE,
    }
}
