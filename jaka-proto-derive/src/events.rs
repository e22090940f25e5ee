//! The severities and explanations of the controller's events, as tables in the order of their codes.

use std::ops::RangeInclusive;
use std::str::FromStr;

use jaka_spec::{Event, EventTexts, Spec};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::scope::ident;

/// The tables in which `ControllerEvent` looks.
pub(crate) fn render(spec: &Spec) -> TokenStream {
    let events: Vec<_> = spec.events().collect();
    let (mut ranges, mut explanations) = (Vec::new(), Vec::new());
    for (first, last, event) in table(&events, Some) {
        let place = Literal::usize_unsuffixed(explanations.len());
        ranges.push(quote!((#first, #last, #place)));
        let severity = ident(event.severity.variant());
        let meaning = option(event.texts.meaning.as_ref().map(|meaning| quote!(#meaning)));
        let note = |note: Option<Note<'_>>| option(note.map(|note| note.render(&quote!(::jaka_proto))));
        let (cause, remedy) = (note(Note::of(spec, event, cause)), note(Note::of(spec, event, remedy)));
        explanations.push(quote!((::jaka_proto::Severity::#severity, #meaning, #cause, #remedy)));
    }
    quote! {
        /// Ranges of codes of events, first and last, in their order, each with its place in `EVENT_EXPLANATIONS`.
        pub(crate) static EVENT_RANGES: &[(u32, u32, usize)] = &[#(#ranges,)*];

        /// Severity, meaning, cause and remedy.
        pub(crate) static EVENT_EXPLANATIONS: &[::jaka_proto::controller_event::Explanation] = &[#(#explanations,)*];
    }
}

/// Functions that know the events that a pack adds, and all others.
pub(crate) fn in_pack(spec: &Spec, events: &[Event]) -> Option<TokenStream> {
    let events: Vec<_> = events.iter().collect();
    let severities = rows(table(&events, |event| Some(event.severity)), |severity| {
        let severity = ident(severity.variant());
        quote!(proto::Severity::#severity)
    });
    let meanings = rows(table(&events, |event| event.texts.meaning.as_deref()), |meaning| quote!(Some(#meaning)));
    let notes = |text: Text| {
        rows(table(&events, |event| Note::of(spec, event, text)), |note| {
            let note = note.render(&quote!(proto));
            quote!(Some(#note))
        })
    };
    let (causes, remedies) = (notes(cause), notes(remedy));
    (!events.is_empty()).then(|| {
        quote! {
            /// Severity of an event of the controller, also of one that only this module names.
            pub fn event_severity(event: proto::ControllerEvent) -> proto::Severity {
                match event.code() {
                    #severities
                    _ => event.severity(),
                }
            }

            /// Meaning of an event of the controller, also of one that only this module explains.
            pub fn event_meaning(event: proto::ControllerEvent) -> Option<&'static str> {
                match event.code() {
                    #meanings
                    _ => event.meaning(),
                }
            }

            /// Causes of an event of the controller, also of one of which only this module says so.
            pub fn event_cause(event: proto::ControllerEvent) -> Option<proto::EventNote> {
                match event.code() {
                    #causes
                    _ => event.cause(),
                }
            }

            /// Remedies for an event of the controller, also for one of which only this module says so.
            pub fn event_remedy(event: proto::ControllerEvent) -> Option<proto::EventNote> {
                match event.code() {
                    #remedies
                    _ => event.remedy(),
                }
            }
        }
    })
}

/// One of the texts of an explanation.
type Text = fn(&EventTexts) -> Option<&str>;

fn cause(texts: &EventTexts) -> Option<&str> {
    texts.cause.as_deref()
}

fn remedy(texts: &EventTexts) -> Option<&str> {
    texts.remedy.as_deref()
}

/// Cause or remedy of an event: its own, or its family's.
#[derive(PartialEq)]
enum Note<'s> {
    OfCode(&'s str),
    OfFamily(&'s str),
}

impl<'s> Note<'s> {
    fn of(spec: &'s Spec, event: &'s Event, text: Text) -> Option<Self> {
        let of_family = || spec.family_of(event).and_then(|family| text(&family.texts)).map(Self::OfFamily);
        text(&event.texts).map(Self::OfCode).or_else(of_family)
    }

    fn render(&self, proto: &TokenStream) -> TokenStream {
        match self {
            Self::OfCode(text) => quote!(#proto::EventNote::OfCode(#text)),
            Self::OfFamily(text) => quote!(#proto::EventNote::OfFamily(#text)),
        }
    }
}

fn option(value: Option<TokenStream>) -> TokenStream {
    value.map_or_else(|| quote!(None), |value| quote!(Some(#value)))
}

/// First and last code of a range, and its text.
type Row<T> = (Literal, Literal, T);

/// Rows for the ranges of codes of the events, in the order of the codes, each with the value that `say` gives for its
/// event. Adjacent ranges with the same value are one row.
fn table<'s, T: PartialEq>(events: &[&'s Event], say: impl Fn(&'s Event) -> Option<T>) -> Vec<Row<T>> {
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
    table.into_iter().map(|(codes, said)| (hexadecimal(*codes.start()), hexadecimal(*codes.end()), said)).collect()
}

/// Arms of a `match` on the code.
fn rows<T>(table: Vec<Row<T>>, value: impl Fn(T) -> TokenStream) -> TokenStream {
    let arms = table.into_iter().map(|(first, last, said)| {
        let value = value(said);
        quote!(#first..=#last => #value,)
    });
    arms.collect()
}

/// The code as the vendor's table has it, so that the expansion can be compared with it.
fn hexadecimal(code: u32) -> Literal {
    Literal::from_str(&jaka_spec::words::event_code(code)).unwrap_or_else(|_| Literal::u32_unsuffixed(code))
}
