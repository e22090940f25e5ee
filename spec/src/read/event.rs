//! The controller's events: codes of one severity with their explanation, and families of events.

use std::ops::RangeInclusive;

use super::common::keyword;
use crate::item::{Item, Placed};
use crate::model::{Event, EventFamily, EventTexts, Severity};
use crate::resolve::{Index, Need};

/// A longer range than this is a mistake, since no source lists that many codes in a row.
const MOST_CODES: u32 = 256;

/// Words that begin a remedy that acts on the arm, or on what keeps it at rest: somebody looks at the arm first.
const LOOK_FIRST: Language = Language {
    look: "when somebody has looked at the arm",
    acts: &[
        "enabl",
        "power on",
        "power it on",
        "power up",
        "clear",
        "acknowledg",
        "confirm",
        "reset",
        "restart",
        "reboot",
        "releas",
        "resume",
        "run again",
        "switch it on",
        "turn it on",
        "turn on",
        "drag the",
        "jog the",
        "jog it",
        "update the",
        "upgrade it",
        "install the",
        "install a",
    ],
};

/// Words in Chinese that begin a remedy that acts on the arm, or on what keeps it at rest.
const LOOK_FIRST_ZH: Language = Language {
    look: "查看过机械臂之后",
    acts: &[
        "使能",
        "上电",
        "清除",
        "确认",
        "复位",
        "重启",
        "恢复",
        "松开",
        "重新运行",
        "点动机",
        "更新到",
        "升级驱动",
        "将其升级",
    ],
};

/// Words of a remedy's rule in a language.
struct Language {
    look: &'static str,
    acts: &'static [&'static str],
}

pub(crate) fn event<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Event {
    let severity = keyword(item, "severity", Severity::WORDS).unwrap_or(Severity::Error);
    let codes = codes(item);
    for range in &codes {
        index.event_codes(item, range);
    }
    let family = item.text("family");
    if let Some(family) = &family {
        index.needs(item, family.at, Need::EventFamily(family.value.clone()));
    }
    let (texts, texts_zh) = texts(item);
    let codes = codes.into_iter().map(|range| range.value).collect();
    let event = Event { severity, codes, texts, texts_zh, family: family.map(|family| family.value) };
    item.finish();
    event
}

pub(crate) fn event_family<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> EventFamily {
    let name = item.required_text("name");
    index.event_family(item, &name);
    item.require("meaning");
    item.require("remedy");
    let (texts, texts_zh) = texts(item);
    let family = EventFamily { name: name.value, texts, texts_zh };
    item.finish();
    family
}

/// The texts in English and in Chinese.
fn texts(item: &Item<'_, '_>) -> (EventTexts, EventTexts) {
    let english = EventTexts {
        meaning: phrase(item, "meaning", None),
        cause: phrase(item, "cause", None),
        remedy: phrase(item, "remedy", Some(&LOOK_FIRST)),
    };
    let chinese = EventTexts {
        meaning: phrase(item, "meaning_zh", None),
        cause: phrase(item, "cause_zh", None),
        remedy: phrase(item, "remedy_zh", Some(&LOOK_FIRST_ZH)),
    };
    let pairs = [
        ("meaning", &english.meaning, &chinese.meaning),
        ("cause", &english.cause, &chinese.cause),
        ("remedy", &english.remedy, &chinese.remedy),
    ];
    for (key, english, chinese) in pairs {
        if english.is_none() && chinese.is_some() {
            item.error(item.at, &format!("`{key}_zh` is without `{key}`"));
        }
    }
    if english.meaning.is_none() && (english.cause.is_some() || english.remedy.is_some()) {
        item.error(item.at, "an event with a cause or a remedy has a `meaning`");
    }
    (english, chinese)
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

fn phrase(item: &Item<'_, '_>, key: &'static str, look_first: Option<&Language>) -> Option<String> {
    let text = item.text(key)?;
    let phrase = text.value;
    let is_phrase = !phrase.is_empty() && phrase.trim() == phrase && !phrase.contains(char::is_control);
    if !is_phrase || phrase.ends_with(['.', '。']) {
        item.error(text.at, &format!("`{key}` is a phrase on one line, without full stop"));
    }
    if let Some((act, look)) = look_first.and_then(|language| acts_before_a_look(&phrase, language)) {
        item.error(text.at, &format!("`{key}` acts on the arm (`{act}`) before it says `{look}`"));
    }
    Some(phrase)
}

/// The word with which a remedy acts on the arm before somebody has looked at it, and the words that have to precede
/// it.
fn acts_before_a_look(remedy: &str, Language { look, acts }: &Language) -> Option<(&'static str, &'static str)> {
    let remedy = remedy.to_lowercase();
    let before = remedy.split(look).next().unwrap_or_default();
    acts.iter().find(|act| before.contains(**act)).map(|act| (*act, *look))
}
