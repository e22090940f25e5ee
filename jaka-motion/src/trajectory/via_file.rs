//! Points without times, from files.

use jaka_proto::messages::types::Pose;

use super::csv::{fields, lines, number};
use super::json::File;
use super::via::Via;
use crate::text_file::{FileErrors, Report, nearest};

/// Number that a column has for each point: its index among six, and the factor to mm or degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Column {
    kind: Kind,
    place: usize,
    factor: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Joints,
    Pose,
}

/// Degrees of a radian.
const DEG: f64 = 180.0 / std::f64::consts::PI;

impl Via {
    /// Reads the points of a CSV text. Errors show `file_name`.
    ///
    /// The first line that is not blank names the columns, each with its unit and in any order: `joint_1_deg` to
    /// `joint_6_deg` for joint positions, or `x_mm`, `y_mm`, `z_mm`, `rx_deg`, `ry_deg` and `rz_deg` for poses of the
    /// tool in the user frame; `rad` in place of `deg` for radians. Each line after it is a point. Numbers are
    /// separated by commas and not quoted; lines that are blank or start with `#` do not count.
    ///
    /// ```
    /// use jaka_motion::Via;
    ///
    /// let text = "x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg\n400,0,300,180,0,0\n400,50,300,180,0,0\n";
    /// assert_eq!(Via::from_csv(text, "seam.csv")?.len(), 2);
    ///
    /// let errors = Via::from_csv(&text.replace("rx_deg", "rx_dge"), "seam.csv").unwrap_err();
    /// assert_eq!(errors.to_string(), "\
    ///     seam.csv:1:1: there is no column `rx_deg` or `rx_rad`\n\
    ///     seam.csv:1:16: unknown column `rx_dge`; is it `rx_deg`?");
    /// # Ok::<(), jaka_motion::TrajectoryFileError>(())
    /// ```
    ///
    /// # Errors
    /// All errors in the text, each at its line and column.
    pub fn from_csv(text: &str, file_name: &str) -> Result<Vec<Self>, FileErrors> {
        let mut report = Report::new(text, file_name);
        let points = read_csv(text, &mut report);
        report.finish(points)
    }

    /// Reads the points of a JSON text. Errors show `file_name`.
    ///
    /// The text is an object with a list `points` of objects, whose keys have the units: `joints_deg` or `joints_rad`,
    /// a list of six numbers; or, for a pose of the tool in the user frame, `position_mm` and `rotation_deg` or
    /// `rotation_rad`, lists of three. `tool_speed_mm_s`, `corner_mm`, `corner_turn_deg` and `corner_deg` apply only to
    /// the path to this point and to its corner.
    ///
    /// ```
    /// use jaka_motion::Via;
    ///
    /// let text = r#"{"points": [
    ///     {"joints_deg": [0, 60, -80, 190, -90, 0]},
    ///     {"position_mm": [400, 0, 300], "rotation_deg": [180, 0, 0], "corner_mm": 20},
    ///     {"position_mm": [400, 0, 200], "rotation_deg": [180, 0, 0], "tool_speed_mm_s": 50}
    /// ]}"#;
    /// assert_eq!(Via::from_json(text, "pick.json")?.len(), 3);
    ///
    /// let errors = Via::from_json(&text.replace("corner_mm", "corner_m"), "pick.json").unwrap_err();
    /// assert_eq!(errors.to_string(), "pick.json:3:77: unknown key `corner_m`; is it `corner_mm`?");
    /// # Ok::<(), jaka_motion::TrajectoryFileError>(())
    /// ```
    ///
    /// # Errors
    /// All errors in the text, each at its line and column; for a text that is not JSON, that error alone.
    pub fn from_json(text: &str, file_name: &str) -> Result<Vec<Self>, FileErrors> {
        let mut report = Report::new(text, file_name);
        let points = read_json(text, &mut report);
        report.finish(points)
    }
}

/// Keys of a point in JSON.
const KEYS: [&str; 9] = [
    "joints_deg",
    "joints_rad",
    "position_mm",
    "rotation_deg",
    "rotation_rad",
    "tool_speed_mm_s",
    "corner_mm",
    "corner_turn_deg",
    "corner_deg",
];

fn read_json(text: &str, report: &mut Report<'_>) -> Vec<Via> {
    let Some(file) = File::new(text, report) else { return Vec::new() };
    let Some(points) = file.points(report) else { return Vec::new() };
    if points.len() < 2 {
        report.error(file.place(file.whole), format!("found {} points, expected at least 2", points.len()));
    }
    points.into_iter().filter_map(|point| point_of(&file, point, report)).collect()
}

/// Reads a point, and reports its errors.
fn point_of<'t>(file: &File<'t>, point: &'t str, report: &mut Report<'_>) -> Option<Via> {
    let entries = file.entries(point, "a point", report)?;
    for (key, value) in entries.iter().filter(|(key, _)| !KEYS.contains(&&**key)) {
        report.error(file.place(value), unknown_key(key));
    }
    let find = |key: &str| entries.iter().find(|(known, _)| known == key).map(|(_, value)| *value);
    let turned = |deg: &'static str, rad: &'static str| {
        find(deg).map(|value| (value, deg, 1.0)).or_else(|| find(rad).map(|value| (value, rad, DEG)))
    };
    let [joints, rotation] =
        [("joints_deg", "joints_rad"), ("rotation_deg", "rotation_rad")].map(|(deg, rad)| turned(deg, rad));
    let via = match (joints, find("position_mm"), rotation) {
        (Some((value, key, factor)), None, None) => {
            let joints: [f64; 6] = file.numbers(value, key, "six", report)?;
            Via::joints(joints.map(|joint| factor * joint))
        }
        (None, Some(position), Some((value, key, factor))) => {
            let position: Option<[f64; 3]> = file.numbers(position, "position_mm", "three", report);
            let rotation: Option<[f64; 3]> = file.numbers(value, key, "three", report);
            let ([x, y, z], [rx, ry, rz]) = (position?, rotation?.map(|angle| factor * angle));
            Via::line([x, y, z, rx, ry, rz])
        }
        _ => {
            let expected = "`joints_deg`, or `position_mm` and `rotation_deg`";
            report.error(file.place(point), format!("a point: expected {expected}, and not both"));
            return None;
        }
    };
    let with: [(&str, WithNumber); 4] = [
        ("tool_speed_mm_s", Via::with_tcp_speed),
        ("corner_mm", Via::with_corner_mm),
        ("corner_turn_deg", Via::with_corner_turn_deg),
        ("corner_deg", Via::with_corner_deg),
    ];
    Some(with.into_iter().fold(via, |via, (key, with)| {
        find(key).and_then(|value| file.number(value, key, report)).map_or(via, |number| with(via, number))
    }))
}

/// Setter for a number of a point.
type WithNumber = fn(Via, f64) -> Via;

fn unknown_key(key: &str) -> String {
    match nearest(key, KEYS.into_iter()) {
        Some(near) => format!("unknown key `{key}`; is it `{near}`?"),
        None => format!("unknown key `{key}`; the keys are {}", KEYS.join(", ")),
    }
}

fn read_csv(text: &str, report: &mut Report<'_>) -> Vec<Via> {
    let mut lines = lines(text);
    let Some((at, header)) = lines.next() else {
        report.error(0, "found no line, expected one that names the columns");
        return Vec::new();
    };
    let columns = columns(at, header, report);
    let kind = columns.iter().flatten().map(|(_, column)| column.kind).next().unwrap_or(Kind::Joints);
    let mut points = Vec::new();
    for (at, line) in lines {
        let count = fields((at, line)).count();
        if count != columns.len() {
            report.error(at, format!("found {count} fields, expected {}, as many as columns", columns.len()));
            continue;
        }
        let mut numbers = [0.0; 6];
        for ((at, field), (name, column)) in
            fields((at, line)).zip(&columns).filter_map(|(field, column)| Some((field, column.as_ref()?)))
        {
            match number(field) {
                Some(number) => numbers[column.place] = number * column.factor,
                None => report.found(at, name, field, "a finite number"),
            }
        }
        points.push(if kind == Kind::Pose { Pose::from(numbers).into() } else { numbers.into() });
    }
    if points.len() < 2 {
        report.error(at, format!("found {} points, expected at least 2", points.len()));
    }
    points
}

/// Returns all possible columns, by name: in degrees or mm, and then in radians.
fn known() -> Vec<(String, Column)> {
    let joints = (0..6).map(|place| (Kind::Joints, place, format!("joint_{}", place + 1)));
    let pose = ["x", "y", "z", "rx", "ry", "rz"].into_iter().enumerate();
    let parts = joints.chain(pose.map(|(place, name)| (Kind::Pose, place, name.to_owned())));
    parts
        .flat_map(|(kind, place, name)| {
            let is_length = kind == Kind::Pose && place < 3;
            let units: &[(&str, f64)] = if is_length { &[("mm", 1.0)] } else { &[("deg", 1.0), ("rad", DEG)] };
            let columns = units
                .iter()
                .map(move |(unit, factor)| (format!("{name}_{unit}"), Column { kind, place, factor: *factor }));
            columns.collect::<Vec<_>>()
        })
        .collect()
}

/// Returns the columns of the header; `None` for one that is unknown.
fn columns(at: usize, header: &str, report: &mut Report<'_>) -> Vec<Option<(String, Column)>> {
    let known = known();
    let mut columns: Vec<Option<(String, Column)>> = Vec::new();
    for (at, name) in fields((at, header)) {
        let column = known.iter().find(|(known, _)| known == name).cloned();
        let first = columns.iter().flatten().map(|(_, column)| *column).next();
        match &column {
            None => report.error(at, unknown(name, &known)),
            Some((_, column)) if first.is_some_and(|first| first.kind != column.kind) => {
                report.error(at, format!("column `{name}`: a file has either joint positions or poses"));
            }
            Some((_, column)) if columns.iter().flatten().any(|(_, other)| other.place == column.place) => {
                report.error(at, format!("column `{name}` appears twice"));
            }
            Some(_) => {}
        }
        columns.push(column);
    }
    let kind = columns.iter().flatten().map(|(_, column)| column.kind).next().unwrap_or(Kind::Joints);
    for place in 0..6 {
        if columns.iter().flatten().any(|(_, column)| column.place == place) {
            continue;
        }
        let names = known.iter().filter(|(_, column)| (column.kind, column.place) == (kind, place));
        let names: Vec<_> = names.map(|(name, _)| format!("`{name}`")).collect();
        report.error(at, format!("there is no column {}", names.join(" or ")));
    }
    columns
}

fn unknown(name: &str, known: &[(String, Column)]) -> String {
    match nearest(name, known.iter().map(|(known, _)| known.as_str())) {
        Some(near) => format!("unknown column `{name}`; is it `{near}`?"),
        None => format!("unknown column `{name}`; they are `joint_1_deg`, `x_mm`, `rx_deg` and the like"),
    }
}
