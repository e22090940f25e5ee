//! Lines and fields of CSV.

/// Field and its offset in the text.
type Field<'t> = (usize, &'t str);

/// Returns the lines with content, with their offsets.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Field<'_>> {
    // Some tools begin a file with a byte order mark.
    let mark = text.len() - text.trim_start_matches('\u{feff}').len();
    let mut next = mark;
    let lines = text[mark..].split_inclusive('\n').map(move |line| {
        let at = next;
        next += line.len();
        (at, line.trim_end_matches(['\n', '\r']))
    });
    lines.filter(|(_, line)| !line.trim().is_empty() && !line.trim_start().starts_with('#'))
}

pub(super) fn fields((mut next, line): Field<'_>) -> impl Iterator<Item = Field<'_>> {
    line.split(',').map(move |field| {
        let at = next + field.len() - field.trim_start().len();
        next += field.len() + 1;
        (at, field.trim())
    })
}

/// Reads a finite number.
pub(super) fn number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite())
}
