//! The severities and meanings of the controller's events, as tables in the order of their codes.

use std::ops::RangeInclusive;
use std::str::FromStr;

use jaka_spec::{Event, Spec};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::scope::ident;

/// The tables in which `ControllerEvent` looks.
pub(crate) fn render(spec: &Spec) -> TokenStream {
    let events: Vec<_> = spec.events().collect();
    let severities =
        severities(&events, |first, last, severity| quote!((#first, #last, ::jaka_proto::Severity::#severity)));
    let meanings = meanings(&events, |first, last, meaning| quote!((#first, #last, #meaning)));
    quote! {
        impl ::jaka_proto::ControllerEvent {
            /// Ranges of codes, first and last, in their order.
            pub(crate) const SEVERITIES: &'static [(u32, u32, ::jaka_proto::Severity)] = &[#(#severities,)*];

            /// Ranges of codes, first and last, in their order.
            pub(crate) const MEANINGS: &'static [(u32, u32, &'static str)] = &[#(#meanings,)*];
        }
    }
}

/// Functions that know the events that a pack adds, and all others.
pub(crate) fn in_pack(events: &[Event]) -> Option<TokenStream> {
    let events: Vec<_> = events.iter().collect();
    let severities = severities(&events, |first, last, severity| quote!(#first..=#last => proto::Severity::#severity,));
    let meanings = meanings(&events, |first, last, meaning| quote!(#first..=#last => Some(#meaning),));
    (!events.is_empty()).then(|| {
        quote! {
            /// How severe an event of the controller is, also one that only this module names.
            pub fn event_severity(event: proto::ControllerEvent) -> proto::Severity {
                match event.code() {
                    #(#severities)*
                    _ => event.severity(),
                }
            }

            /// What an event of the controller means, also one of which only this module says so.
            pub fn event_meaning(event: proto::ControllerEvent) -> Option<&'static str> {
                match event.code() {
                    #(#meanings)*
                    _ => event.meaning(),
                }
            }
        }
    })
}

/// A row for each range of codes of one severity.
fn severities(events: &[&Event], row: impl Fn(Literal, Literal, Ident) -> TokenStream) -> Vec<TokenStream> {
    table(events, |event| Some(event.severity), |first, last, severity| row(first, last, ident(severity.variant())))
}

/// A row for each range of codes of one meaning.
fn meanings(events: &[&Event], row: impl Fn(Literal, Literal, &str) -> TokenStream) -> Vec<TokenStream> {
    table(events, |event| event.meaning.as_deref(), row)
}

/// The events of ranges of codes, in the order of the codes. Neighbours with the same event are one range.
fn table<'s, T: PartialEq>(
    events: &[&'s Event],
    say: impl Fn(&'s Event) -> Option<T>,
    row: impl Fn(Literal, Literal, T) -> TokenStream,
) -> Vec<TokenStream> {
    let mut ranges: Vec<_> =
        events.iter().flat_map(|event| event.codes.iter().map(move |codes| (codes, event))).collect();
    ranges.sort_by_key(|(codes, _)| *codes.start());
    let mut table: Vec<(RangeInclusive<u32>, T)> = Vec::new();
    for (codes, event) in ranges {
        let Some(said) = say(event) else { continue };
        match table.last_mut() {
            Some((before, same)) if before.end().checked_add(1) == Some(*codes.start()) && *same == said => {
                *before = *before.start()..=*codes.end();
            }
            _ => table.push((codes.clone(), said)),
        }
    }
    let rows = table.into_iter().map(|(codes, said)| row(hexadecimal(*codes.start()), hexadecimal(*codes.end()), said));
    rows.collect()
}

/// The code as the vendor's table has it, so that the expansion can be compared with it.
fn hexadecimal(code: u32) -> Literal {
    Literal::from_str(&jaka_spec::words::event_code(code)).unwrap_or_else(|_| Literal::u32_unsuffixed(code))
}
