//! The texts of the spec.

/// Splits a text behind its first sentence, which stands alone.
pub fn first_sentence(text: &str) -> (&str, &str) {
    let end = ["\n\n", ". ", ".\n"].iter().filter_map(|end| Some(text.find(end)? + usize::from(end.starts_with('.'))));
    end.min().map_or((text, ""), |end| text.split_at(end))
}
