//! Points of trajectories in CSV and JSON: numbers by names with units.

use std::borrow::Cow;

use jaka_proto::wire::{DecodeError, Reader};
use serde_json::value::RawValue;

use super::timed::TimedPoint;
use super::via::Via;
use crate::text_file::{FileErrors, Report};

/// Format of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Csv,
    Json,
}

/// Numbers of a point that belong together.
#[derive(Debug)]
struct Quantity {
    /// Key in JSON, without the unit.
    key: &'static str,
    /// Names of its columns in CSV, without the unit; none for a number that only JSON has.
    columns: &'static [&'static str],
    /// Units, each with the factor to seconds, mm or degrees.
    units: &'static [(&'static str, f64)],
}

/// Kind of points.
#[derive(Debug)]
struct Kind {
    quantities: &'static [Quantity],
    /// Returns the quantities that a point must have that has these.
    needed: fn(&Given) -> &'static [usize],
}

/// Flags for the quantities that a point has.
type Given = [bool; 7];

/// Name of a column or key, with its meaning.
#[derive(Debug)]
struct Name {
    text: String,
    quantity: usize,
    /// Index among the numbers of the quantity.
    index: usize,
    factor: f64,
}

/// Numbers of a point, by quantity. A number that could not be read is NaN.
#[derive(Debug)]
struct Row {
    /// Offset in the text.
    at: usize,
    numbers: [Option<[f64; 6]>; 7],
}

/// File that is read.
struct File<'t> {
    text: &'t str,
    format: Format,
    kind: &'static Kind,
    names: Vec<Name>,
}

/// Degrees of a radian.
const DEG: f64 = 180.0 / std::f64::consts::PI;

const ANGLES: &[(&str, f64)] = &[("deg", 1.0), ("rad", DEG)];

const JOINTS: Quantity = Quantity {
    key: "joints",
    columns: &["joint_1", "joint_2", "joint_3", "joint_4", "joint_5", "joint_6"],
    units: ANGLES,
};

/// Points with times.
static TIMED: Kind = Kind {
    quantities: &[
        Quantity { key: "time", columns: &["time"], units: &[("s", 1.0)] },
        JOINTS,
        Quantity {
            key: "velocity",
            columns: &["velocity_1", "velocity_2", "velocity_3", "velocity_4", "velocity_5", "velocity_6"],
            units: &[("deg_s", 1.0), ("rad_s", DEG)],
        },
        Quantity {
            key: "acceleration",
            columns: &[
                "acceleration_1",
                "acceleration_2",
                "acceleration_3",
                "acceleration_4",
                "acceleration_5",
                "acceleration_6",
            ],
            units: &[("deg_s2", 1.0), ("rad_s2", DEG)],
        },
    ],
    needed: |given| if given[3] { &[0, 1, 2] } else { &[0, 1] },
};

/// Points without times: joint positions or poses.
static VIA: Kind = Kind {
    quantities: &[
        JOINTS,
        Quantity { key: "position", columns: &["x", "y", "z"], units: &[("mm", 1.0)] },
        Quantity { key: "rotation", columns: &["rx", "ry", "rz"], units: ANGLES },
        Quantity { key: "tool_speed", columns: &[], units: &[("mm_s", 1.0)] },
        Quantity { key: "corner", columns: &[], units: &[("mm", 1.0)] },
        Quantity { key: "corner_turn", columns: &[], units: &[("deg", 1.0)] },
        Quantity { key: "corner", columns: &[], units: &[("deg", 1.0)] },
    ],
    needed: |given| if given[1] || given[2] { &[1, 2] } else { &[0] },
};

/// Key of the list in a JSON file.
const POINTS: &str = "points";

impl TimedPoint {
    /// Reads the points of a CSV text. Errors show `file_name`.
    ///
    /// The first line that is not blank names the columns, each with its unit and in any order: `time_s`; `joint_1_deg`
    /// to `joint_6_deg`, or `joint_1_rad` and so on; optionally `velocity_1_deg_s` or `velocity_1_rad_s`, and
    /// `acceleration_1_deg_s2` or `acceleration_1_rad_s2`. Each line after it is a point. Fields are separated by
    /// commas and may be quoted; lines that are blank or start with `#` do not count. The first time is 0, and times
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
    ///
    /// let wrong = text.replace("0.1,", "O.1,").replace("joint_6_rad", "joint_6");
    /// let errors = TimedPoint::from_csv(&wrong, "way.csv").unwrap_err();
    /// assert_eq!(
    ///     errors.to_string(),
    ///     "way.csv:1:1: there is no column `joint_6_deg` or `joint_6_rad`\n\
    ///      way.csv:1:1: unknown column `joint_6`; they are `time_s`, `joint_1_deg`, `joint_1_rad`, \
    ///      `velocity_1_deg_s`, `velocity_1_rad_s`, `acceleration_1_deg_s2`, `acceleration_1_rad_s2`\n\
    ///      way.csv:3:1: joint_1_rad: found `O.1`, expected a finite number"
    /// );
    /// # Ok::<(), jaka_motion::TrajectoryFileError>(())
    /// ```
    ///
    /// # Errors
    /// All errors in the text, each at its line and with its column's name.
    pub fn from_csv(text: &str, file_name: &str) -> Result<Vec<Self>, FileErrors> {
        timed(Format::Csv, text, file_name)
    }

    /// Reads the points of a JSON text. Errors show `file_name`.
    ///
    /// The text is an object with a list `points` of objects, whose keys have the units: `time_s`; `joints_deg` or
    /// `joints_rad`, a list of six numbers; optionally `velocity_deg_s` or `velocity_rad_s`, and `acceleration_deg_s2`
    /// or `acceleration_rad_s2`. All points have the same keys. The first time is 0, and times increase.
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
    ///
    /// let errors = TimedPoint::from_json(&text.replace("[5,", "[\"5\","), "way.json").unwrap_err();
    /// assert_eq!(errors.to_string(), "way.json:3:34: joints_deg: found `\"5\"`, expected a finite number");
    /// # Ok::<(), jaka_motion::TrajectoryFileError>(())
    /// ```
    ///
    /// # Errors
    /// All errors in the text, each at its line and column; for a text that is not JSON, that error alone.
    pub fn from_json(text: &str, file_name: &str) -> Result<Vec<Self>, FileErrors> {
        timed(Format::Json, text, file_name)
    }
}

impl Via {
    /// Reads the points of a CSV text. Errors show `file_name`.
    ///
    /// The first line that is not blank names the columns, each with its unit and in any order: `joint_1_deg` to
    /// `joint_6_deg` for joint positions, or `x_mm`, `y_mm`, `z_mm`, `rx_deg`, `ry_deg` and `rz_deg` for poses of the
    /// tool in the user frame; `rad` in place of `deg` for radians. Each line after it is a point. Fields are separated
    /// by commas and may be quoted; lines that are blank or start with `#` do not count.
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
    ///     seam.csv:1:1: unknown column `rx_dge`; they are `joint_1_deg`, `joint_1_rad`, `x_mm`, `rx_deg`, `rx_rad`");
    /// # Ok::<(), jaka_motion::TrajectoryFileError>(())
    /// ```
    ///
    /// # Errors
    /// All errors in the text, each at its line and with its column's name.
    pub fn from_csv(text: &str, file_name: &str) -> Result<Vec<Self>, FileErrors> {
        vias(Format::Csv, text, file_name)
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
    /// assert!(errors.to_string().starts_with("pick.json:3:77: unknown key `corner_m`; they are `joints_deg`, "));
    /// # Ok::<(), jaka_motion::TrajectoryFileError>(())
    /// ```
    ///
    /// # Errors
    /// All errors in the text, each at its line and column; for a text that is not JSON, that error alone.
    pub fn from_json(text: &str, file_name: &str) -> Result<Vec<Self>, FileErrors> {
        vias(Format::Json, text, file_name)
    }
}

/// Reads points with times: see [`TimedPoint::from_csv`].
fn timed(format: Format, text: &str, file_name: &str) -> Result<Vec<TimedPoint>, FileErrors> {
    let mut report = Report::new(text, file_name);
    let rows = File::new(&TIMED, format, text).rows(&mut report);
    let mut last_s = None;
    for row in &rows {
        if row.given() != rows[0].given() {
            report.error(row.at, "a point: its keys differ from the keys of the first point");
        }
        let Some([time_s, ..]) = row.numbers[0].filter(|[time_s, ..]| time_s.is_finite()) else { continue };
        match last_s.replace(time_s) {
            None if time_s != 0.0 => report.found(row.at, "time_s", &time_s.to_string(), "0, at the first point"),
            Some(last_s) if time_s <= last_s => {
                report.found(row.at, "time_s", &time_s.to_string(), &format!("more than the {last_s} before it"));
            }
            _ => {}
        }
    }
    let points = rows.into_iter().map(|Row { numbers: [time, joints, velocity, acceleration, ..], .. }| TimedPoint {
        time_s: time.unwrap_or_default()[0],
        joints: joints.unwrap_or_default().into(),
        velocity,
        acceleration,
    });
    report.finish(points.collect())
}

/// Reads points without times: see [`Via::from_csv`].
fn vias(format: Format, text: &str, file_name: &str) -> Result<Vec<Via>, FileErrors> {
    let mut report = Report::new(text, file_name);
    let rows = File::new(&VIA, format, text).rows(&mut report);
    let points = rows.into_iter().map(|Row { numbers: [joints, position, rotation, own @ ..], .. }| {
        let via = joints.map_or_else(
            || {
                let ([x, y, z, ..], [rx, ry, rz, ..]) = (position.unwrap_or_default(), rotation.unwrap_or_default());
                Via::line([x, y, z, rx, ry, rz])
            },
            Via::joints,
        );
        let with = [Via::with_tcp_speed, Via::with_corner_mm, Via::with_corner_turn_deg, Via::with_corner_deg];
        own.into_iter().zip(with).fold(via, |via, (own, with)| own.map_or(via, |[number, ..]| with(via, number)))
    });
    report.finish(points.collect())
}

impl Quantity {
    /// Returns a key or column with its unit.
    fn named(&self, name: &str, unit: usize) -> String {
        format!("{name}_{}", self.units[unit].0)
    }

    /// Returns a key or column in each unit, for a message.
    fn in_units(&self, name: &str) -> String {
        let all: Vec<_> = (0..self.units.len()).map(|unit| format!("`{}`", self.named(name, unit))).collect();
        all.join(" or ")
    }
}

impl Row {
    fn given(&self) -> Given {
        self.numbers.map(|numbers| numbers.is_some())
    }
}

impl<'t> File<'t> {
    fn new(kind: &'static Kind, format: Format, text: &'t str) -> Self {
        let mut names = Vec::new();
        for (quantity, of) in kind.quantities.iter().enumerate() {
            let texts = if format == Format::Csv { of.columns } else { &[of.key][..] };
            for (index, text) in texts.iter().enumerate() {
                names.extend(of.units.iter().enumerate().map(|(unit, (_, factor))| Name {
                    text: of.named(text, unit),
                    quantity,
                    index,
                    factor: *factor,
                }));
            }
        }
        Self { text, format, kind, names }
    }

    fn rows(&self, report: &mut Report<'_>) -> Vec<Row> {
        let rows = match self.format {
            Format::Csv => self.lines(report),
            Format::Json => self.objects(report),
        };
        let Some(rows) = rows else { return Vec::new() };
        if rows.len() < 2 {
            report.error(0, format!("found {} points, expected at least 2", rows.len()));
        }
        rows.into_iter().flatten().collect()
    }

    /// Reads CSV; `None` for a line that cannot be read.
    fn lines(&self, report: &mut Report<'_>) -> Option<Vec<Option<Row>>> {
        let reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .from_reader(self.text.as_bytes());
        // A text makes no error: it is UTF-8 and in memory.
        let records = reader.into_records().filter_map(Result::ok);
        let mut records = records.filter(|record| record.len() > 1 || record.iter().any(|field| !field.is_empty()));
        let Some(header) = records.next() else {
            report.error(0, "found no line, expected one that names the columns");
            return None;
        };
        let (at, mut columns) = (self.start(&header), Vec::new());
        for name in &header {
            let column = self.name(at, name, &columns, report);
            columns.push(column);
        }
        let has = |quantity, index| {
            columns.iter().flatten().any(|column: &&Name| (column.quantity, column.index) == (quantity, index))
        };
        let given: Given = std::array::from_fn(|quantity| (0..6).any(|index| has(quantity, index)));
        self.check_kind(at, &given, report);
        for (quantity, of) in self.kind.quantities.iter().enumerate() {
            let is_needed = given[quantity] || (self.kind.needed)(&given).contains(&quantity);
            for (_, column) in of.columns.iter().enumerate().filter(|(index, _)| is_needed && !has(quantity, *index)) {
                report.error(at, format!("there is no column {}", of.in_units(column)));
            }
        }
        let rows = records.map(|record| {
            let mut row = Row { at: self.start(&record), numbers: [None; 7] };
            if record.len() != columns.len() {
                let (count, columns) = (record.len(), columns.len());
                report.error(row.at, format!("found {count} fields, expected {columns}, as many as columns"));
                return None;
            }
            for (column, field) in columns.iter().zip(&record).filter_map(|(column, field)| Some(((*column)?, field))) {
                let numbers = row.numbers[column.quantity].get_or_insert_default();
                numbers[column.index] = column.factor * number(row.at, &column.text, field, report);
            }
            Some(row)
        });
        Some(rows.collect())
    }

    /// Returns the offset of a record: the crate's is before blank lines and comments.
    fn start(&self, record: &csv::StringRecord) -> usize {
        let mut at = record.position().and_then(|place| usize::try_from(place.byte()).ok()).unwrap_or(0);
        let lines = self.text.get(at..).unwrap_or_default().split_inclusive('\n');
        let skipped = lines.take_while(|line| line.trim_end_matches(['\r', '\n']).is_empty() || line.starts_with('#'));
        at += skipped.map(str::len).sum::<usize>();
        at
    }

    /// Reads JSON; `None` for a point that cannot be read.
    fn objects(&self, report: &mut Report<'_>) -> Option<Vec<Option<Row>>> {
        let whole = match serde_json::from_str::<&RawValue>(self.text) {
            Ok(whole) => whole.get(),
            Err(error) => {
                let said = error.to_string();
                // The error has the place already.
                let reason = said.rsplit_once(" at line ").map_or(said.as_str(), |(reason, _)| reason);
                let lines = self.text.split_inclusive('\n').map(str::len);
                let line_start: usize = lines.take(error.line().saturating_sub(1)).sum();
                report.error(line_start + error.column().saturating_sub(1), format!("not valid JSON: {reason}"));
                return None;
            }
        };
        let mut points = None;
        for (key, value) in self.entries(whole, "the file", report)? {
            if key != POINTS {
                report.error(self.place(value), format!("unknown key `{key}`; the only key is `{POINTS}`"));
            } else if points.replace(value).is_some() {
                report.error(self.place(value), format!("key `{key}` appears twice"));
            }
        }
        let Some(points) = points else {
            report.error(self.place(whole), format!("`{POINTS}` is missing"));
            return None;
        };
        let points = self.list(points, POINTS, "a list of objects", report)?;
        Some(points.into_iter().map(|point| self.object(point, report)).collect())
    }

    fn object(&self, point: &'t str, report: &mut Report<'_>) -> Option<Row> {
        let (mut row, mut names) = (Row { at: self.place(point), numbers: [None; 7] }, Vec::new());
        for (key, value) in self.entries(point, "a point", report)? {
            let at = self.place(value);
            let name = self.name(at, &key, &names, report);
            names.push(name);
            let Some(name) = name else { continue };
            let numbers = row.numbers[name.quantity].get_or_insert_default();
            let count = self.kind.quantities[name.quantity].columns.len();
            let values =
                if count > 1 { self.list(value, &key, "a list of numbers", report) } else { Some(vec![value]) };
            let Some(values) = values else { continue };
            if values.len() != count.max(1) {
                report.error(at, format!("{key}: found {} numbers, expected {count}", values.len()));
            }
            for (part, value) in numbers.iter_mut().zip(values) {
                *part = name.factor * number(self.place(value), &key, value, report);
            }
        }
        let given = row.given();
        self.check_kind(row.at, &given, report);
        for quantity in (self.kind.needed)(&given).iter().filter(|quantity| !given[**quantity]) {
            let of = &self.kind.quantities[*quantity];
            report.error(row.at, format!("a point: {} is missing", of.in_units(of.key)));
        }
        Some(row)
    }

    /// Returns the meaning of a name. Reports one that is unknown, or has the meaning of a name before it.
    fn name(&self, at: usize, text: &str, before: &[Option<&Name>], report: &mut Report<'_>) -> Option<&Name> {
        let what = if self.format == Format::Csv { "column" } else { "key" };
        let Some(name) = self.names.iter().find(|name| name.text == text) else {
            let first = self.names.iter().filter(|name| name.index == 0);
            let known: Vec<_> = first.map(|name| format!("`{}`", name.text)).collect();
            report.error(at, format!("unknown {what} `{text}`; they are {}", known.join(", ")));
            return None;
        };
        if before.iter().flatten().any(|other| (other.quantity, other.index) == (name.quantity, name.index)) {
            report.error(at, format!("{what} `{text}` appears twice"));
        }
        Some(name)
    }

    /// Reports joint positions beside a pose.
    fn check_kind(&self, at: usize, given: &Given, report: &mut Report<'_>) {
        if std::ptr::eq(self.kind, &raw const VIA) && given[0] && (given[1] || given[2]) {
            report.error(at, "expected joint positions or a pose, and not both");
        }
    }

    /// Returns the offset of a value, which is a part of the text.
    fn place(&self, value: &str) -> usize {
        (value.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize)
    }

    /// Returns the entries of an object in their order, with the texts of their values.
    fn entries(&self, value: &'t str, what: &str, report: &mut Report<'_>) -> Option<Vec<(Cow<'t, str>, &'t str)>> {
        let read = || -> Result<_, DecodeError> {
            let (mut reader, mut entries) = (Reader::new(value), Vec::new());
            reader.begin_object()?;
            while let Some(key) = reader.next_key()? {
                entries.push((key, reader.raw()?));
            }
            Ok(entries)
        };
        let entries = read();
        if entries.is_err() {
            report.found(self.place(value), what, value, "an object");
        }
        entries.ok()
    }

    fn list(&self, value: &'t str, what: &str, expected: &str, report: &mut Report<'_>) -> Option<Vec<&'t str>> {
        let list = serde_json::from_str::<Vec<&RawValue>>(value);
        if list.is_err() {
            report.found(self.place(value), what, value, expected);
        }
        Some(list.ok()?.into_iter().map(RawValue::get).collect())
    }
}

/// Reads a finite number. Reports another text, and returns NaN.
fn number(at: usize, what: &str, text: &str, report: &mut Report<'_>) -> f64 {
    text.parse().ok().filter(|number: &f64| number.is_finite()).unwrap_or_else(|| {
        report.found(at, what, text, "a finite number");
        f64::NAN
    })
}
