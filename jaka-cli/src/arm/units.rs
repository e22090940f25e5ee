//! Numbers that seem to be in another unit.

/// Unit of joints, corresponding unit of tool lines, and the largest usual number in the latter.
const OF_LINES: [(&str, &str, f64); 2] = [("deg/s", "mm/s", 10_000.0), ("deg/s²", "mm/s²", 8000.0)];

/// Returns a line with a hint, if a number beyond the allowed range, such as `at most 265 deg/s`, would be usual in
/// another unit.
pub(crate) fn other_unit(number: f64, allowed: &str) -> Option<String> {
    let (of_joints, of_lines, most) = *OF_LINES.iter().find(|(unit, ..)| allowed.ends_with(&format!(" {unit}")))?;
    (number > 0.0 && number <= most).then(|| {
        format!("\nhint: joint motions take {of_joints}, tool lines {of_lines}; {number} may be meant in {of_lines}")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_would_be_usual_is_suggested() {
        let hint = other_unit(500.0, "more than 0, at most 265 deg/s").expect("it is usual for lines");
        assert_eq!(hint, "\nhint: joint motions take deg/s, tool lines mm/s; 500 may be meant in mm/s");
        assert!(
            other_unit(3000.0, "at most 720 deg/s²").is_some_and(|hint| hint.ends_with("3000 may be meant in mm/s²"))
        );
        for (number, allowed) in
            [(0.0, "more than 0, at most 265 deg/s"), (20_000.0, "at most 265 deg/s"), (20_000.0, "at most 10000 mm/s")]
        {
            assert_eq!(other_unit(number, allowed), None, "{number}, {allowed}");
        }
    }
}
