//! Numbers that look like another unit's.

/// Unit of joints, the unit of the tool's lines in its place, and the largest number that is usual in the latter.
const OF_LINES: [(&str, &str, f64); 2] = [("deg/s", "mm/s", 10_000.0), ("deg/s²", "mm/s²", 8000.0)];

/// A line with a hint, where a number that is not within what is allowed, such as `at most 265 deg/s`, would be usual
/// in another unit.
pub(crate) fn other_unit(number: f64, allowed: &str) -> Option<String> {
    let (of_joints, of_lines, most) = *OF_LINES.iter().find(|(unit, ..)| allowed.ends_with(&format!(" {unit}")))?;
    (number > 0.0 && number <= most).then(|| {
        format!(
            "\nhint: motions of joints take {of_joints}, lines of the tool {of_lines}: {number} was perhaps meant in {of_lines}"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_would_be_usual_is_suggested() {
        let hint = other_unit(500.0, "more than 0, at most 265 deg/s").expect("it is usual for lines");
        assert_eq!(hint, "\nhint: motions of joints take deg/s, lines of the tool mm/s: 500 was perhaps meant in mm/s");
        assert!(
            other_unit(3000.0, "at most 720 deg/s²")
                .is_some_and(|hint| hint.ends_with("3000 was perhaps meant in mm/s²"))
        );
        for (number, allowed) in
            [(0.0, "more than 0, at most 265 deg/s"), (20_000.0, "at most 265 deg/s"), (20_000.0, "at most 10000 mm/s")]
        {
            assert_eq!(other_unit(number, allowed), None, "{number}, {allowed}");
        }
    }
}
