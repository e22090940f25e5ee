//! The controller's events: their place in the reference, and a page of their own by code, in two languages.

use std::fmt::Write as _;

use super::markdown::{Table, code, escape};
use crate::words::{event_code, list};
use crate::{Event, EventTexts, Severity, Spec};

/// Edition of the page in one language.
struct Edition {
    title: &'static str,
    about: &'static str,
    head: [&'static str; 6],
    /// Heading of the families, their sentence, and the head of their table.
    families: (&'static str, &'static str, [&'static str; 4]),
    texts: fn(&Event) -> &EventTexts,
    family_texts: fn(&crate::EventFamily) -> &EventTexts,
    severity: fn(Severity) -> &'static str,
}

const ENGLISH: Edition = Edition {
    title: "Events of JAKA controllers",
    about: include_str!("../../../reference/event_table.md"),
    head: ["code", "severity", "meaning", "cause", "remedy", "family"],
    families: (
        "Families",
        "Causes and remedies of events for which the table states none.",
        ["family", "events", "cause", "remedy"],
    ),
    texts: |event| &event.texts,
    family_texts: |family| &family.texts,
    severity: Severity::word,
};

const CHINESE: Edition = Edition {
    title: "JAKA 控制器事件",
    about: include_str!("../../../reference/zh/event_table.md"),
    head: ["事件码", "级别", "含义", "原因", "措施", "类别"],
    families: ("类别", "厂家的表没有给出原因或措施时适用。", ["类别", "事件", "原因", "措施"]),
    texts: |event| &event.texts_zh,
    family_texts: |family| &family.texts_zh,
    severity: |severity| match severity {
        Severity::Error => "错误",
        Severity::Warning => "报警",
        Severity::Information => "信息",
    },
};

/// All [events](crate::Event) of a spec in Markdown: a table by code with severity, meaning, cause and remedy.
///
/// A cause or a remedy of the event's family is in italics. Links lead to `REFERENCE.md` in the same folder.
pub fn events(spec: &Spec) -> String {
    page(spec, &ENGLISH)
}

/// The Chinese edition of the [events](events).
pub fn events_zh(spec: &Spec) -> String {
    page(spec, &CHINESE)
}

fn page(spec: &Spec, edition: &Edition) -> String {
    let mut out = format!("# {}\n\n{}\n", edition.title, edition.about);
    let mut events: Vec<_> = spec.events().collect();
    events.sort_by_key(|event| event.codes().min());
    let mut table = Table::new(&edition.head);
    for event in events {
        let codes: Vec<_> = event.codes().map(|one| code(&event_code(one))).collect();
        let texts = (edition.texts)(event);
        let family = spec.family_of(event).map(edition.family_texts);
        let [cause, remedy] = [
            (&texts.cause, family.and_then(|family| family.cause.as_ref())),
            (&texts.remedy, family.and_then(|family| family.remedy.as_ref())),
        ]
        .map(|(own, family)| match (own, family) {
            (Some(own), _) => escape(own),
            (None, Some(family)) => format!("*{}*", escape(family)),
            (None, None) => String::new(),
        });
        let meaning = texts.meaning.as_deref().map(escape).unwrap_or_default();
        let severity = (edition.severity)(event.severity).to_owned();
        table.row([codes.join(", "), severity, meaning, cause, remedy, event.family.clone().unwrap_or_default()]);
    }
    table.render(&mut out);
    let (heading, sentence, head) = &edition.families;
    let _ = writeln!(out, "## {heading}\n\n{sentence}\n");
    let mut table = Table::new(head);
    for family in spec.event_families() {
        let texts = (edition.family_texts)(family);
        let [meaning, cause, remedy] =
            [&texts.meaning, &texts.cause, &texts.remedy].map(|text| text.as_deref().map(escape).unwrap_or_default());
        table.row([family.name.clone(), meaning, cause, remedy]);
    }
    table.render(&mut out);
    out.truncate(out.trim_end().len());
    out + "\n"
}

/// The line of the index.
pub(super) fn index(out: &mut String, events: &[Event]) {
    if !events.is_empty() {
        let _ = writeln!(out, "- Events: {}, [by code](EVENTS.md)", counts(&events.iter()));
    }
}

/// A sentence that leads to the page by code.
pub(super) fn render(out: &mut String, events: &[Event]) {
    if !events.is_empty() {
        let counts = counts(&events.iter());
        let _ =
            writeln!(out, "{counts}. Meaning, cause and remedy of each stand in [EVENTS.md](EVENTS.md), by code.\n");
    }
}

/// `3 errors, 1 warning and 2 of information`.
fn counts<'e>(events: &(impl Iterator<Item = &'e Event> + Clone)) -> String {
    let names = [
        (Severity::Error, "error", "errors"),
        (Severity::Warning, "warning", "warnings"),
        (Severity::Information, "of information", "of information"),
    ];
    let counts = names.into_iter().filter_map(|(severity, one, many)| {
        let of_it = events.clone().filter(|event| event.severity == severity);
        match of_it.map(|event| event.codes().count()).sum() {
            0 => None,
            1 => Some(format!("1 {one}")),
            count => Some(format!("{count} {many}")),
        }
    });
    list(&counts.collect::<Vec<_>>(), "and")
}
