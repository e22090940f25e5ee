//! Names that are near to one that does not exist.

/// How many are named.
const MOST: usize = 3;

/// What to try instead.
pub(super) fn hint<'n>(wanted: &str, names: impl Iterator<Item = &'n str>) -> String {
    let mut near: Vec<_> = names.filter_map(|name| Some((nearness(wanted, name)?, name))).collect();
    near.sort_unstable();
    near.dedup();
    if near.is_empty() {
        return "`jaka status --fields all` shows them all".to_owned();
    }
    let near: Vec<_> = near.iter().take(MOST).map(|(_, name)| format!("`{name}`")).collect();
    format!("near it: {}", near.join(", "))
}

/// The number of letters that differ, if that is few; names that contain the wanted one come behind those.
fn nearness(wanted: &str, name: &str) -> Option<usize> {
    let few = wanted.len() / 4 + 1;
    let apart = distance(wanted, name);
    if apart <= few {
        return Some(apart);
    }
    (wanted.len() >= 3 && name.contains(wanted)).then_some(few + name.len())
}

/// How many letters must be put in, taken out or changed to make one text of the other.
fn distance(one: &str, other: &str) -> usize {
    let mut row: Vec<usize> = (0..=other.len()).collect();
    for (i, a) in one.bytes().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, b) in other.bytes().enumerate() {
            let changed = diagonal + usize::from(a != b);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[other.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_those_of_levenshtein() {
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("same", "same"), 0);
    }
}
