//! Files of a spec.

use jaka_spec::{Errors, Source, load, tools};

/// The text is loaded as a spec of one file. Its errors stand at places that it has. Of what loaded, all else can be
/// made.
///
/// # Panics
/// One of these is not so.
pub fn spec_file(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let spec = match load(&[Source { path: "spec/fuzz.toml", text }]) {
        Ok(spec) => spec,
        Err(errors) => return places(&errors, text),
    };
    assert!(tools::diff(&spec, &spec).is_empty());
    tools::reference(&spec);
    tools::schema(&spec);
}

/// Each error has a line and column of the text, or the place right after it.
pub(crate) fn places(errors: &Errors, text: &str) {
    let lines: Vec<_> = text.split('\n').collect();
    assert!(errors.iter().next().is_some(), "a failure without an error");
    for error in errors {
        let line = lines.get(error.line.wrapping_sub(1)).unwrap_or_else(|| panic!("there is no such line: {error}"));
        assert!((1..=line.chars().count() + 1).contains(&error.column), "there is no such column: {error}");
    }
}
