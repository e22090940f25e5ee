//! Random edits: one for each row of the table of `jaka_spec::tools::diff`, and more.

mod commands;
mod fields;
mod parts;

use toml::{Table, Value};

use crate::draft::{Draft, Place};
use crate::random::Random;

/// Makes a change of its kind at a random place, and says which; nothing if there is no such place.
type Make = fn(&mut Draft, &mut Random) -> Option<String>;

/// A kind of edits.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Kind {
    pub(crate) name: &'static str,
    pub(crate) make: Make,
}

/// All kinds.
pub(crate) fn kinds() -> Vec<Kind> {
    [commands::KINDS, fields::KINDS, parts::KINDS].concat()
}

/// Percentage of edits that are made in the topic of rare constructs, which is the last file, where that has a place.
const RARE: usize = 50;

/// One of these places for which `fits` is true.
fn pick(draft: &Draft, random: &mut Random, places: Vec<Place>, fits: impl Fn(&Table) -> bool) -> Option<Place> {
    let places: Vec<_> = places.into_iter().filter(|place| fits(draft.table(place))).collect();
    let last = draft.files().len() - 1;
    let rare: Vec<_> = places.iter().filter(|place| place.file == last).cloned().collect();
    let from = if random.percent(RARE) && !rare.is_empty() { &rare } else { &places };
    random.pick(from).cloned()
}

/// Sets a key, or removes it where it is set; says so.
fn toggle(draft: &mut Draft, place: &Place, key: &str, value: impl Into<Value>) -> String {
    let table = draft.table_mut(place);
    let what = if table.remove(key).is_some() {
        format!("without `{key}`")
    } else {
        let value = value.into();
        let what = format!("{key} = {value}");
        table.insert(key.to_owned(), value);
        what
    };
    format!("{}: {what}", draft.describe(place))
}

/// Sets a key, whatever it was; says so.
fn set(draft: &mut Draft, place: &Place, key: &str, value: impl Into<Value>) -> String {
    let (value, at) = (value.into(), draft.describe(place));
    let what = format!("{at}: {key} = {value}");
    draft.table_mut(place).insert(key.to_owned(), value);
    what
}

/// Removes a table from its list; says so.
fn remove(draft: &mut Draft, place: &Place) -> String {
    let what = format!("{}: removed", draft.describe(place));
    draft.remove(place);
    what
}

/// Exchanges a table with another of its list; says so.
fn reorder(draft: &mut Draft, random: &mut Random, place: &Place) -> Option<String> {
    let what = format!("{}: at another place", draft.describe(place));
    let list = place.list();
    let table = draft.remove(place);
    let tables = draft.list_mut(&list);
    if tables.is_empty() {
        return None;
    }
    let at = random.below(tables.len() + 1);
    tables.insert(at, Value::Table(table));
    Some(what)
}

fn table(text: &str) -> Table {
    text.parse().unwrap_or_else(|error| panic!("{error}: {text}"))
}

fn tables(text: &str) -> Value {
    table(&format!("tables = {text}")).remove("tables").expect("it is there")
}

/// The keys of a text for people.
const TEXTS: &[&str] = &["doc", "doc", "doc", "title", "title_zh", "message", "meaning"];

/// Another text for people.
fn reword(draft: &mut Draft, random: &mut Random, places: Vec<Place>) -> Option<String> {
    let key = *random.pick(TEXTS)?;
    let place = pick(draft, random, places, |table| table.contains_key(key))?;
    Some(set(draft, &place, key, "Another text"))
}
