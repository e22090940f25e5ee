//! Points with times, from files and to files.

mod columns;
mod csv;
mod json;
mod rows;
mod write;

use super::timed::TimedPoint;
use crate::TrajectoryFileError;
use crate::text_file::Report;

/// Number of characters that are shown at most of what was found.
const SHOWN: usize = 40;

impl Report<'_> {
    /// Reports what was found in place of something.
    fn found(&mut self, at: usize, what: &str, found: &str, expected: &str) {
        let short: String = found.chars().take(SHOWN).collect();
        let rest = if short.len() < found.len() { "..." } else { "" };
        self.error(at, format!("{what}: found `{short}{rest}`, expected {expected}"));
    }
}

impl TimedPoint {
    /// The points of a CSV text; `file_name` is what errors name.
    ///
    /// The first line that is not blank names the columns, each with its unit and in any order: `time_s`; `joint_1_deg`
    /// to `joint_6_deg`, or `joint_1_rad` and so on; and if they are given `velocity_1_deg_s` or `velocity_1_rad_s`,
    /// and `acceleration_1_deg_s2` or `acceleration_1_rad_s2`. Each line after it is a point. Numbers are separated by
    /// commas and not quoted; lines that are blank or start with `#` do not count. The first time is 0, and times
    /// increase.
    ///
    /// ```
    /// use jaka_motion::TimedPoint;
    ///
    /// let text = "\
    /// time_s,joint_1_rad,joint_2_rad,joint_3_rad,joint_4_rad,joint_5_rad,joint_6_rad
    /// 0.0,0.0,1.0471975511965976,-1.3962634015954636,3.3161255787892263,-1.5707963267948966,0.0
    /// 1.0,0.1,1.0471975511965976,-1.3962634015954636,3.3161255787892263,-1.5707963267948966,0.0
    /// ";
    /// let points = TimedPoint::from_csv(text, "way.csv")?;
    /// assert!((points[1].joints.0[1] - 60.0).abs() < 1e-12);
    /// assert_eq!(TimedPoint::from_csv(&TimedPoint::to_csv(&points), "way.csv")?, points);
    ///
    /// let errors = TimedPoint::from_csv(&text.replace("0.1,", "O.1,").replace("joint_6_rad", "joint_6"), "way.csv").unwrap_err();
    /// assert_eq!(
    ///     errors.to_string(),
    ///     "way.csv:1:1: there is no column `joint_6_deg` or `joint_6_rad`\n\
    ///      way.csv:1:68: unknown column `joint_6`; they are `time_s`, `joint_1_deg`, `joint_1_rad` and the like\n\
    ///      way.csv:3:5: joint_1_rad: found `O.1`, expected a finite number"
    /// );
    /// # Ok::<(), jaka_motion::TrajectoryFileError>(())
    /// ```
    ///
    /// # Errors
    /// Everything that is wrong, at its line and column.
    pub fn from_csv(text: &str, file_name: &str) -> Result<Vec<Self>, TrajectoryFileError> {
        let mut report = Report::new(text, file_name);
        let points = csv::read(text, &mut report);
        report.finish(points)
    }

    /// The points of a JSON text; `file_name` is what errors name.
    ///
    /// An object with a list `points` of objects, whose keys have the units: `time_s`; `joints_deg` or `joints_rad`, a
    /// list of six numbers; and if they are given `velocity_deg_s` or `velocity_rad_s`, and `acceleration_deg_s2` or
    /// `acceleration_rad_s2`. All points have the same. The first time is 0, and times increase.
    ///
    /// ```
    /// use jaka_motion::TimedPoint;
    ///
    /// let text = r#"{"points": [
    ///     {"time_s": 0, "joints_deg": [0, 60, -80, 190, -90, 0]},
    ///     {"time_s": 1, "joints_deg": [5, 60, -80, 190, -90, 0]}
    /// ]}"#;
    /// let points = TimedPoint::from_json(text, "way.json")?;
    /// assert_eq!((points.len(), points[1].joints.0[0]), (2, 5.0));
    /// assert_eq!(TimedPoint::from_json(&TimedPoint::to_json(&points), "way.json")?, points);
    ///
    /// let errors = TimedPoint::from_json(&text.replace("[5,", "[\"5\","), "way.json").unwrap_err();
    /// assert_eq!(errors.to_string(), "way.json:3:34: joints_deg: found `\"5\"`, expected a finite number");
    /// # Ok::<(), jaka_motion::TrajectoryFileError>(())
    /// ```
    ///
    /// # Errors
    /// Everything that is wrong, at its line and column; where the text is not JSON, that alone.
    pub fn from_json(text: &str, file_name: &str) -> Result<Vec<Self>, TrajectoryFileError> {
        let mut report = Report::new(text, file_name);
        let points = json::read(text, &mut report);
        report.finish(points)
    }

    /// The points as CSV, in degrees, which [`from_csv`](Self::from_csv) reads as the same points.
    ///
    /// The columns are those that all points have.
    pub fn to_csv(points: &[Self]) -> String {
        write::csv(points)
    }

    /// The points as JSON, in degrees, which [`from_json`](Self::from_json) reads as the same points.
    ///
    /// The keys are those that all points have.
    pub fn to_json(points: &[Self]) -> String {
        write::json(points)
    }
}
