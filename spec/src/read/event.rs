//! The controller's events: codes, and ranges of codes, of one severity.

use std::ops::RangeInclusive;

use super::common::keyword;
use crate::item::{Item, Placed};
use crate::model::{Event, Severity};
use crate::resolve::Index;

/// A longer range than this is a mistake, since no source lists that many codes in a row.
const MOST_CODES: u32 = 256;

pub(crate) fn event<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Event {
    let severity = keyword(item, "severity", Severity::WORDS).unwrap_or(Severity::Error);
    let codes = codes(item);
    for range in &codes {
        index.event_codes(item, range);
    }
    let event = Event { severity, codes: codes.into_iter().map(|range| range.value).collect(), meaning: meaning(item) };
    item.finish();
    event
}

fn codes<'s>(item: &Item<'_, 's>) -> Vec<Placed<'s, RangeInclusive<u32>>> {
    let texts = item.texts("codes");
    if texts.is_empty() {
        item.error(item.at, "`codes` is missing or empty");
    }
    let mut ranges = Vec::new();
    for text in &texts {
        match range(&text.value) {
            Ok(value) => ranges.push(Placed { at: text.at, value }),
            Err(message) => item.error(text.at, &message),
        }
    }
    ranges
}

/// Reads `0x0F0034`, or `0x0F0006-0x0F0009`.
fn range(text: &str) -> Result<RangeInclusive<u32>, String> {
    let (first, last) = text.split_once('-').unwrap_or((text, text));
    let (Some(first), Some(last)) = (code(first), code(last)) else {
        return Err(format!("`{text}` is not a code such as 0x0F0034, nor a range such as 0x0F0006-0x0F0009"));
    };
    if first == 0 {
        return Err("0 says that there is no event".to_owned());
    }
    if text.contains('-') && first >= last {
        return Err(format!("`{text}` does not go from a code to a greater one"));
    }
    if last - first >= MOST_CODES {
        return Err(format!("`{text}` has more than {MOST_CODES} codes"));
    }
    Ok(first..=last)
}

fn code(text: &str) -> Option<u32> {
    // Rust's own reading would take a sign too.
    let digits = text.strip_prefix("0x").filter(|digits| digits.bytes().all(|byte| byte.is_ascii_hexdigit()))?;
    u32::from_str_radix(digits, 16).ok()
}

fn meaning(item: &Item<'_, '_>) -> Option<String> {
    let text = item.text("meaning")?;
    let meaning = text.value;
    let is_phrase = !meaning.is_empty() && meaning.trim() == meaning && !meaning.contains(char::is_control);
    if !is_phrase || meaning.ends_with('.') {
        item.error(text.at, "`meaning` is a phrase on one line, without full stop");
    }
    Some(meaning)
}
