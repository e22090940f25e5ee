//! Values: how they are written, also in the forms of fields by firmware, and how those are read.

use jaka_spec::{Factors, Field, Form, Scalar, Type, Version, Versions};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// Statements that write a field in the form of the firmware, with its key where it has one; `value` is a reference to
/// its value.
pub(crate) fn write(field: &Field, value: &TokenStream) -> TokenStream {
    let write = |form: &Form| {
        let key = form.key();
        let before = if form.wire.is_empty() { quote!(out.comma();) } else { quote!(out.key(#key);) };
        let write = write_scaled(&form.ty, &quote!(value), form.factors);
        quote!({ #before #write })
    };
    let (ranges, own) = (ranges(field.forms.iter().map(|form| &form.versions)), write(&field.own_form()));
    let arms = arms(field.forms.iter().map(write));
    let write = quote!(match out.form(#ranges) { #arms _ => #own });
    if field.optional { quote!(if let Some(value) = #value { #write }) } else { quote!({ let value = #value; #write }) }
}

/// A statement that writes the value behind a reference, in another unit where the factor is not one.
fn write_scaled(ty: &Type, value: &TokenStream, factors: Factors) -> TokenStream {
    if factors.are_one() {
        return write_type(ty, value);
    }
    let factor = Literal::f64_unsuffixed(factors.to);
    write_type(ty, &quote!(&wire::Scaled::times(#value, #factor)))
}

/// Forms whose keys are not those of the fields, one for each key, with its field's place.
pub(crate) fn further_keys(fields: &[Field]) -> Vec<(usize, Form)> {
    let of_field = |(at, field): (usize, &Field)| -> Vec<(usize, Form)> {
        field.keys().skip(1).filter_map(|key| Some((at, field.forms_under(key).next()?))).collect()
    };
    fields.iter().enumerate().flat_map(of_field).collect()
}

/// A closure that reads the value of a field under one of its keys.
pub(crate) fn read(field: &Field, key: &str) -> TokenStream {
    let forms: Vec<_> = field.forms_under(key).collect();
    if field.are_alike_under(key) {
        let ranges = ranges(field.forms.iter().map(|form| &form.versions));
        let at_key = |form: &Form| if form.wire == key { read_one(&form.ty, form.factors) } else { ambiguous() };
        let (arms, own) = (arms(field.forms.iter().map(at_key)), at_key(&field.own_form()));
        return quote!(|reader| match reader.form(#ranges)? { #arms _ => #own });
    }
    let factors = forms.first().map_or(Factors::ONE, |form| form.factors);
    let truths: Vec<_> = forms.iter().filter_map(|form| truth_words(&form.ty)).collect();
    let (literal, plain): (Vec<_>, Vec<_>) = forms.iter().partition(|form| matches!(form.ty, Type::Python(_)));
    let read = match (plain.first(), literal.first()) {
        _ if !truths.is_empty() => {
            let words = truths.iter().map(|[off, on]| quote!([#off, #on]));
            quote!(reader.words(&[#(#words),*]))
        }
        (Some(plain), Some(literal)) => {
            let [plain, literal] = [plain, literal].map(|form| read_one(&form.ty, factors));
            return quote!(|reader| if reader.is_literal() { #literal } else { #plain });
        }
        (Some(form), None) | (None, Some(form)) => return closure(&read_one(&form.ty, factors)),
        (None, None) => ambiguous(),
    };
    closure(&read)
}

fn closure(read: &TokenStream) -> TokenStream {
    quote!(|reader| #read)
}

fn ambiguous() -> TokenStream {
    quote!(Err(wire::DecodeError::ambiguous()))
}

/// An expression that reads a value of one form.
fn read_one(ty: &Type, factors: Factors) -> TokenStream {
    let read = match ty {
        Type::Python(_) => quote!(reader.python()),
        other => truth_words(other)
            .map_or_else(|| quote!(wire::Decode::decode(reader)), |[off, on]| quote!(reader.words(&[[#off, #on]]))),
    };
    if factors.are_one() {
        return read;
    }
    let factor = Literal::f64_unsuffixed(factors.from);
    quote!(#read.map(|value| wire::Scaled::times(&value, #factor)))
}

fn truth_words(ty: &Type) -> Option<[&str; 2]> {
    if let Type::Scalar(scalar) = ty { scalar.truth_words() } else { None }
}

/// An expression that gives an element of an array the unit of its field; `read` reads it as it stands there.
pub(crate) fn element(field: &Field, read: &TokenStream) -> TokenStream {
    if field.forms.is_empty() {
        return read.clone();
    }
    let name = &field.name;
    let ranges = ranges(field.forms.iter().map(|form| &form.versions));
    let arms = arms(field.forms.iter().map(|form| {
        let factor = Literal::f64_unsuffixed(form.factors.from);
        quote!(wire::Scaled::times(&value, #factor))
    }));
    quote! {{
        let value = #read;
        match reader.form(#ranges).map_err(|error| error.in_field(#name))? { #arms _ => value }
    }}
}

/// The fields of an object as elements of an array.
pub(crate) fn elements(fields: &[Field]) -> Vec<Field> {
    fields.iter().map(|field| Field { wire: String::new(), ..field.clone() }).collect()
}

/// An arm for each form.
pub(crate) fn arms(bodies: impl Iterator<Item = TokenStream>) -> TokenStream {
    let arms = bodies.enumerate().map(|(at, body)| {
        let at = Literal::usize_unsuffixed(at);
        quote!(Some(#at) => #body,)
    });
    quote!(#(#arms)*)
}

/// The firmware of each form.
pub(crate) fn ranges<'f>(versions: impl Iterator<Item = &'f Versions>) -> TokenStream {
    let ranges = versions.map(|versions| firmware_of(versions, &quote!(wire)));
    quote!(&[#(#ranges),*])
}

/// The firmware that has something, unless all has it.
pub(crate) fn firmware(versions: &Versions) -> Option<TokenStream> {
    (versions != &Versions::default()).then(|| firmware_of(versions, &quote!(proto)))
}

/// The firmware that has something, by the module that has the type of ranges.
pub(crate) fn firmware_of(versions: &Versions, module: &TokenStream) -> TokenStream {
    let numbers = |version: &Version| {
        let numbers = version.numbers().iter().map(|number| Literal::u32_unsuffixed(*number));
        quote!([#(#numbers),*])
    };
    let since = versions.since.as_ref().map(numbers).map(|numbers| quote!(.since(#numbers)));
    let until = versions.until.as_ref().map(numbers).map(|numbers| quote!(.until(#numbers)));
    quote!(#module::FirmwareRange::ALL #since #until)
}

/// A statement that writes the value behind the reference `value`.
pub(crate) fn write_type(ty: &Type, value: &TokenStream) -> TokenStream {
    match ty {
        Type::Scalar(Scalar::Bool { off, on }) if off != "false" || on != "true" => {
            quote!(out.choose(*#value, #off, #on);)
        }
        Type::List(element) | Type::Array(element, _) if is_truth(element) => {
            let write = write_type(element, &quote!(item));
            quote!(out.array(#value, |out, item| { #write });)
        }
        Type::Python(inner) => {
            let write = write_type(inner, value);
            quote!(out.python(|out| { #write });)
        }
        Type::Scalar(_) | Type::Named(_) | Type::List(_) | Type::Array(..) => {
            quote!(wire::Encode::encode(#value, out);)
        }
    }
}

/// True for a truth value, and for an array of them.
fn is_truth(ty: &Type) -> bool {
    match ty {
        Type::List(element) | Type::Array(element, _) => is_truth(element),
        other => matches!(other, Type::Scalar(Scalar::Bool { .. })),
    }
}
