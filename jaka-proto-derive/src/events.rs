//! The severities and meanings of the controller's events, as tables in the order of their codes.

use std::ops::RangeInclusive;
use std::str::FromStr;

use jaka_spec::{Event, Severity, Spec};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::codec::ident;

/// The tables in which `ControllerEvent` looks.
pub(crate) fn render(spec: &Spec) -> TokenStream {
    let severities = table(spec.events(), |event| Some(event.severity)).into_iter().map(|(codes, severity)| {
        let (first, last) = (hexadecimal(*codes.start()), hexadecimal(*codes.end()));
        let severity = variant(severity);
        quote!((#first, #last, ::jaka_proto::Severity::#severity))
    });
    let meanings = table(spec.events(), |event| event.meaning.as_deref()).into_iter().map(|(codes, meaning)| {
        let (first, last) = (hexadecimal(*codes.start()), hexadecimal(*codes.end()));
        quote!((#first, #last, #meaning))
    });
    quote! {
        impl ::jaka_proto::ControllerEvent {
            /// Ranges of codes, first and last, in their order.
            pub(crate) const SEVERITIES: &'static [(u32, u32, ::jaka_proto::Severity)] = &[#(#severities,)*];

            /// Ranges of codes, first and last, in their order.
            pub(crate) const MEANINGS: &'static [(u32, u32, &'static str)] = &[#(#meanings,)*];
        }
    }
}

/// Functions that know the events that a pack adds beside all others.
pub(crate) fn in_pack(events: &[Event]) -> Option<TokenStream> {
    let severities = table(events.iter(), |event| Some(event.severity)).into_iter().map(|(codes, severity)| {
        let (first, last) = (hexadecimal(*codes.start()), hexadecimal(*codes.end()));
        let severity = variant(severity);
        quote!(#first..=#last => proto::Severity::#severity,)
    });
    let meanings = table(events.iter(), |event| event.meaning.as_deref()).into_iter().map(|(codes, meaning)| {
        let (first, last) = (hexadecimal(*codes.start()), hexadecimal(*codes.end()));
        quote!(#first..=#last => Some(#meaning),)
    });
    (!events.is_empty()).then(|| {
        quote! {
            /// How grave an event of the controller is, also one that only this module names.
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

/// What events say of ranges of codes, in the order of the codes. Neighbours of which the same is said are one range.
fn table<'s, T: PartialEq>(
    events: impl Iterator<Item = &'s Event>,
    say: impl Fn(&'s Event) -> Option<T>,
) -> Vec<(RangeInclusive<u32>, T)> {
    let mut ranges: Vec<_> = events.flat_map(|event| event.codes.iter().map(move |codes| (codes, event))).collect();
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
    table
}

fn variant(severity: Severity) -> proc_macro2::Ident {
    ident(match severity {
        Severity::Error => "Error",
        Severity::Warning => "Warning",
        Severity::Information => "Information",
    })
}

/// The code as the vendor's table has it, so that the expansion can be compared with it.
fn hexadecimal(code: u32) -> Literal {
    Literal::from_str(&jaka_spec::words::event_code(code)).unwrap_or_else(|_| Literal::u32_unsuffixed(code))
}
