//! The checks of requests, and of the types inside them.

use jaka_spec::words;
use jaka_spec::{Advice, Choice, Command, EnumValue, Field, Request, TypeDef, TypeKind, Version, Versions};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::choice::variant_path;
use crate::scope::{Scope, ident, names};

/// The checks of a request.
pub(crate) fn request(scope: Scope<'_>, command: &Command, name: &Ident) -> TokenStream {
    let body = match &command.request {
        Request::Fields(fields) => struct_body(scope, fields),
        Request::Choice(choice) => choice_body(scope, choice, None),
    };
    implement(name, &body)
}

/// The checks of a type.
pub(crate) fn type_def(scope: Scope<'_>, def: &TypeDef) -> TokenStream {
    let name = ident(&def.name);
    let body = match &def.kind {
        TypeKind::Object(fields) | TypeKind::Array { fields, .. } => struct_body(scope, fields),
        TypeKind::IntEnum(values) => {
            let allowed = list(values, |value| format!("{} ({})", value.wire, value.name));
            enum_body(values, &allowed, &quote!(i64::from(*self)))
        }
        TypeKind::TextEnum(values) => {
            let allowed = list(values, |value| format!("`{}`", value.wire));
            enum_body(values, &allowed, &quote!(self.as_ref()))
        }
        TypeKind::Wrapper(_, unit) => {
            let unit = unit.as_deref().unwrap_or_default();
            quote! {
                let limits = check::FieldLimits { unit: #unit, ..*limits };
                check::Validate::validate(&self.0, place, &limits)
            }
        }
        TypeKind::Choice(choice) => choice_body(scope, choice, Some(&quote!(Self::Other(_) => {}))),
    };
    implement(&name, &body)
}

fn implement(name: &Ident, body: &TokenStream) -> TokenStream {
    quote! {
        impl check::Validate for #name {
            #[allow(unused_variables)]
            #[inline]
            fn validate(
                &self,
                place: &check::Place<'_>,
                limits: &check::FieldLimits,
            ) -> Result<(), check::NotSent> {
                #body
            }
        }
    }
}

/// The checks of each variant; `other` is the arm of what the spec does not list.
fn choice_body(scope: Scope<'_>, choice: &Choice, other: Option<&TokenStream>) -> TokenStream {
    let arms = choice.variants.iter().map(|variant| {
        let (path, names) = (variant_path(variant), names(&variant.fields));
        let checks = checks(scope, &variant.fields, |name| quote!(#name));
        quote!(#path { #(#names),* } => { #checks })
    });
    quote!(match self { #(#arms)* #other } Ok(()))
}

fn struct_body(scope: Scope<'_>, fields: &[Field]) -> TokenStream {
    let checks = checks(scope, fields, |name| quote!(&self.#name));
    quote!(#checks Ok(()))
}

fn checks(scope: Scope<'_>, fields: &[Field], value: impl Fn(&Ident) -> TokenStream) -> TokenStream {
    let gap = gap(fields, &value);
    let checks = fields.iter().map(|field| {
        let advised = advised(scope, (fields, field), &value);
        let (text, value, limits) = (&field.name, value(&ident(&field.name)), limits(field, advised));
        quote!(place.check(#text, #value, &#limits)?;)
    });
    quote!(#gap #(#checks)*)
}

/// The check that no element of an array is left out before another, where that can be.
fn gap(fields: &[Field], value: impl Fn(&Ident) -> TokenStream) -> Option<TokenStream> {
    let optional: Vec<_> = fields.iter().filter(|field| field.optional && field.wire.is_empty()).collect();
    let elements = optional.iter().map(|field| {
        let (text, value) = (&field.name, value(&ident(&field.name)));
        quote!((#text, Option::is_some(#value)))
    });
    (optional.len() > 1).then(|| quote!(place.no_gap(&[#(#elements),*])?;))
}

/// Expression for the limits that are advised of a field, one of `fields`; `value` gives the value of each of them.
fn advised(
    scope: Scope<'_>,
    (fields, field): (&[Field], &Field),
    value: impl Fn(&Ident) -> TokenStream,
) -> Option<TokenStream> {
    let first = field.advised.first()?;
    let Some(selector) = &first.when else { return Some(rows(&field.advised.iter().collect::<Vec<_>>(), value)) };
    let selector = fields.iter().find(|other| other.name == selector.field)?;
    let id = selector.ty.named()?;
    let (path, selected) = (scope.path(id), value(&ident(&selector.name)));
    let TypeKind::IntEnum(values) = &scope.spec[id].kind else { return None };
    let arms = values.iter().filter_map(|listed| {
        let is_meant = |row: &&Advice| row.when.as_ref().is_some_and(|when| when.value == listed.wire);
        let meant: Vec<_> = field.advised.iter().filter(is_meant).collect();
        let (name, rows) = (ident(&listed.name), rows(&meant, &value));
        (!meant.is_empty()).then(|| quote!(#path::#name => #rows,))
    });
    Some(quote!(match #selected { #(#arms)* _ => check::Advised::NONE, }))
}

fn rows(rows: &[&Advice], value: impl Fn(&Ident) -> TokenStream) -> TokenStream {
    let times = rows.first().and_then(|row| row.per.as_ref()).map(|count| {
        let count = value(&ident(count));
        quote!(.times(Clone::clone(#count)))
    });
    let rows = rows.iter().map(|Advice { max, nonzero, unit, .. }| {
        let unit = unit.as_deref().unwrap_or_default();
        quote!(check::Advice { max: #max, nonzero: #nonzero, unit: #unit })
    });
    quote!(check::Advised::to(&[#(#rows),*]) #times)
}

fn limits(field: &Field, advised: Option<TokenStream>) -> TokenStream {
    let bound = |bound: Option<f64>| bound.map(|bound| quote!(Some(#bound)));
    let min = bound(field.range.min).map(|min| quote!(min: #min,));
    let max = bound(field.range.max).map(|max| quote!(max: #max,));
    let advisory = field.range.advisory.then(|| quote!(advisory: true,));
    let ascii = field.ascii.then(|| quote!(ascii: true,));
    let unit = field.unit.as_deref().map(|unit| quote!(unit: #unit,));
    let firmware = firmware(&field.versions).map(|firmware| quote!(firmware: #firmware,));
    let advised = advised.map(|advised| quote!(advised: #advised,));
    let set = [min, max, advisory, advised, ascii, unit, firmware];
    if set.iter().all(Option::is_none) {
        return quote!(check::FieldLimits::NONE);
    }
    let set = set.iter().flatten();
    quote!(check::FieldLimits { #(#set)* ..check::FieldLimits::NONE })
}

/// The firmware that has something, unless all has it.
pub(crate) fn firmware(versions: &Versions) -> Option<TokenStream> {
    let numbers = |version: &Version| {
        let numbers = version.numbers().iter().map(|number| Literal::u32_unsuffixed(*number));
        quote!([#(#numbers),*])
    };
    let since = versions.since.as_ref().map(numbers).map(|numbers| quote!(.since(#numbers)));
    let until = versions.until.as_ref().map(numbers).map(|numbers| quote!(.until(#numbers)));
    (versions != &Versions::default()).then(|| quote!(proto::FirmwareRange::ALL #since #until))
}

fn list<T>(values: &[EnumValue<T>], text: impl Fn(&EnumValue<T>) -> String) -> String {
    let listed: Vec<_> = values.iter().filter(|value| !value.advisory).map(text).collect();
    words::list(&listed, "or")
}

fn enum_body<T>(values: &[EnumValue<T>], allowed: &str, wire: &TokenStream) -> TokenStream {
    let arm = |advisory: bool, standing: TokenStream| {
        let names: Vec<_> = values.iter().filter(|v| v.advisory == advisory).map(|v| ident(&v.name)).collect();
        (!names.is_empty()).then(|| quote!(#(Self::#names)|* => check::Standing::#standing,))
    };
    let listed = arm(false, quote!(Listed));
    let newer = arm(true, quote!(Advisory));
    let bounded = values.iter().filter_map(|value| {
        let (name, firmware) = (ident(&value.name), firmware(&value.versions)?);
        Some(quote!(Self::#name => place.takes(&#wire, &#firmware)?,))
    });
    let arms: Vec<_> = bounded.collect();
    let versions = (!arms.is_empty()).then(|| quote!(match self { #(#arms)* _ => {} }));
    quote! {
        let standing = match self {
            #listed
            #newer
            Self::Other(_) => check::Standing::Unknown,
        };
        #versions
        place.listed(&#wire, standing, #allowed)
    }
}
