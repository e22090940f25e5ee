//! The controller's events, code by code. Neighbours that change alike are reported in one line.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use super::Impact;
use super::collect::{ADDED, Differ, REMOVED};
use crate::words::event_codes;
use crate::{Event, Spec};

/// Description of the change of an event, and its impact.
type What = (String, Impact);

/// Compares the events of both specs.
pub(super) fn compare(d: &mut Differ<'_>) {
    let (old, new) = (by_code(d.old), by_code(d.new));
    let codes: BTreeSet<_> = old.keys().chain(new.keys()).copied().collect();
    let mut runs: Vec<(RangeInclusive<u32>, Vec<What>)> = Vec::new();
    for code in codes {
        let changes = changes(old.get(&code).copied(), new.get(&code).copied());
        match runs.last_mut() {
            Some((run, same)) if run.end().checked_add(1) == Some(code) && *same == changes => {
                *run = *run.start()..=code;
            }
            _ => runs.push((code..=code, changes)),
        }
    }
    for (codes, changes) in runs {
        let place = format!("event `{}`", event_codes(&codes));
        for (what, impact) in changes {
            d.note(&place, what, impact);
        }
    }
}

fn by_code(spec: &Spec) -> BTreeMap<u32, &Event> {
    spec.events().flat_map(|event| event.codes().map(move |code| (code, event))).collect()
}

/// The change of the event of one code.
fn changes(old: Option<&Event>, new: Option<&Event>) -> Vec<What> {
    let (old, new) = match (old, new) {
        (Some(old), Some(new)) => (old, new),
        (Some(_), None) => return vec![(REMOVED.to_owned(), Impact::Minor)],
        (None, _) => return vec![(ADDED.to_owned(), Impact::Minor)],
    };
    let mut changes = Vec::new();
    if old.severity != new.severity {
        let (old, new) = (old.severity.word(), new.severity.word());
        changes.push((format!("severity changed from `{old}` to `{new}`"), Impact::Minor));
    }
    let texts = [
        ("meaning", old.texts.meaning != new.texts.meaning),
        ("cause", old.texts.cause != new.texts.cause),
        ("remedy", old.texts.remedy != new.texts.remedy),
        ("Chinese texts", old.texts_zh != new.texts_zh),
        ("family", old.family != new.family),
    ];
    for (text, _) in texts.into_iter().filter(|(_, is_changed)| *is_changed) {
        changes.push((format!("{text} changed"), Impact::Patch));
    }
    changes
}
