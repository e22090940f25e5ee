//! Names that are similar to one that does not exist.

use jaka_spec::words::distance;

/// How many suggestions are made at most.
const MOST: usize = 3;

/// What to try instead.
pub(super) fn hint<'n>(wanted: &str, names: impl Iterator<Item = &'n str>) -> String {
    let mut suggestions: Vec<_> = names.filter_map(|name| Some((unlikeness(wanted, name)?, name))).collect();
    suggestions.sort_unstable();
    suggestions.dedup();
    if suggestions.is_empty() {
        return "`jaka status --fields all` shows them all".to_owned();
    }
    let suggestions: Vec<_> = suggestions.iter().take(MOST).map(|(_, name)| format!("`{name}`")).collect();
    format!("similar names: {}", suggestions.join(", "))
}

/// The number of letters that differ, if that is few; names that contain the wanted one come after those.
fn unlikeness(wanted: &str, name: &str) -> Option<usize> {
    let few = wanted.len() / 4 + 1;
    let apart = distance(wanted, name);
    if apart <= few {
        return Some(apart);
    }
    (wanted.len() >= 3 && name.contains(wanted)).then_some(few + name.len())
}
