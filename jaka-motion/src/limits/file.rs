//! Limits from a TOML file.

mod reader;

use jaka_spec::Source;
use jaka_spec::words::nearest;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use self::reader::{Placed, Reader, Table};
use super::{InvalidLimit, Limits, LimitsFileError, Point, Region, RegionFrame};
use crate::model::Model;

impl Limits {
    /// The limits that a TOML text states, over those of [`of`](Self::of); `file_name` is what errors name.
    ///
    /// Units are part of the keys. All but `model` may be left out, and a number in place of a list is for all six joints.
    ///
    /// ```
    /// use jaka_motion::Limits;
    ///
    /// let text = r#"
    /// model = "Zu 5"
    ///
    /// [joints]
    /// min_deg = [-170, -80, -150, -80, -175, -360]
    /// max_deg = [170, 260, 150, 260, 175, 360]
    /// speed_deg_s = 90
    /// acceleration_deg_s2 = [60, 60, 90, 90, 120, 120] # not published for these arms
    ///
    /// [tcp]
    /// speed_mm_s = 250
    ///
    /// [singularity]
    /// least_distance = 0.05
    ///
    /// [[half_space]]
    /// name = "table"
    /// of = "tcp"           # or "elbow", "wrist"
    /// frame = "user"       # or "base": the arm's own base, however it is mounted
    /// point_mm = [0, 0, 20]
    /// inward = [0, 0, 1]   # a direction, of any length
    ///
    /// [[box]]
    /// name = "camera"
    /// of = "elbow"
    /// frame = "base"
    /// keep = "outside"     # or "inside"
    /// min_mm = [300, -100, 0]
    /// max_mm = [500, 100, 900]
    /// "#;
    /// let limits = Limits::from_toml(text, "limits.toml")?;
    /// assert_eq!((limits.joint_speeds()[5], limits.regions().len()), (90.0, 2));
    ///
    /// let errors = Limits::from_toml("model = \"Zu 5\"\n[tcp]\nspeed_mms = 250", "limits.toml").unwrap_err();
    /// assert_eq!(errors.to_string(), "limits.toml:3:1: tcp: unknown key `speed_mms`; is it `speed_mm_s`?");
    /// # Ok::<(), jaka_motion::LimitsFileError>(())
    /// ```
    ///
    /// # Errors
    /// Everything that is wrong, at its line and column.
    pub fn from_toml(text: &str, file_name: &str) -> Result<Self, LimitsFileError> {
        let source = Source { path: file_name, text };
        let mut reader = Reader::new(source);
        let (table, errors) = DeTable::parse_recoverable(text);
        for error in errors {
            reader.error(error.span().unwrap_or(0..0).start, format!("not valid TOML: {}", error.message()));
        }
        let limits = read(&mut reader, &table);
        match (limits, reader.finish()) {
            (Some(limits), errors) if errors.is_empty() => Ok(limits),
            (_, errors) => Err(errors.into_iter().collect()),
        }
    }
}

/// None without a model; what is wrong is in the reader.
fn read(reader: &mut Reader<'_>, file: &Spanned<DeTable<'_>>) -> Option<Limits> {
    let file = Table::new(String::new(), file.span().start, file.get_ref());
    reader.keys(&file, &["model", "joints", "tcp", "singularity", "box", "half_space"]);
    let limits = model(reader, &file).map(Limits::of);
    // The rest is read without a model too, for its errors.
    let mut stated = limits.clone().unwrap_or_else(|| Limits::of(&Model::default()));
    let known = limits.is_some();
    joints(reader, &file, known, &mut stated);
    if let Some(tcp) = reader.table(&file, "tcp") {
        reader.keys(&tcp, &["speed_mm_s"]);
        if let Some(speed) = reader.number(&tcp, "speed_mm_s") {
            apply(reader, speed.at, &mut stated, |limits| limits.with_tcp_speed(speed.value));
        }
    }
    if let Some(singularity) = reader.table(&file, "singularity") {
        reader.keys(&singularity, &["least_distance"]);
        if let Some(least) = reader.number(&singularity, "least_distance") {
            apply(reader, least.at, &mut stated, |limits| limits.with_singularity_distance(least.value));
        }
    }
    for table in reader.tables(&file, "box") {
        let region = boxed(reader, &table);
        add(reader, &table, region, &mut stated);
    }
    for table in reader.tables(&file, "half_space") {
        let region = half_space(reader, &table);
        add(reader, &table, region, &mut stated);
    }
    known.then_some(stated)
}

fn model(reader: &mut Reader<'_>, file: &Table<'_, '_>) -> Option<&'static Model> {
    let name = reader.required(file, "model", Reader::text)?;
    let model = Model::named(&name.value);
    if model.is_none() {
        let names = Model::published().iter().map(Model::name);
        let hint = match nearest(&name.value, names.clone()) {
            Some(near) => format!("is it `{near}`?"),
            None => format!("the arms are {}", names.collect::<Vec<_>>().join(", ")),
        };
        reader.error(name.at, format!("there is no arm `{}`; {hint}", name.value));
    }
    model
}

/// Ranges and speeds are compared with the model's, if it is known.
fn joints(reader: &mut Reader<'_>, file: &Table<'_, '_>, known: bool, limits: &mut Limits) {
    let Some(joints) = reader.table(file, "joints") else { return };
    reader.keys(&joints, &["min_deg", "max_deg", "speed_deg_s", "acceleration_deg_s2"]);
    let [min, max] = ["min_deg", "max_deg"].map(|key| reader.six(&joints, key));
    let speeds = reader.six(&joints, "speed_deg_s");
    let accelerations = reader.six(&joints, "acceleration_deg_s2");
    if !known {
        return;
    }
    for joint in 1..=6 {
        let of = |given: &Option<[Placed<f64>; 6]>| given.as_ref().map(|given| given[joint - 1]);
        let (low, high) = (of(&min), of(&max));
        let low_deg = low.map_or(limits.joint_min[joint - 1], |low| low.value);
        let high_deg = high.map_or(limits.joint_max[joint - 1], |high| high.value);
        // Each end by itself first, so that an error stands at the one that is wrong.
        let ends = [(low, low_deg, low_deg), (high, high_deg, high_deg), (low.or(high), low_deg, high_deg)];
        for (given, min, max) in ends {
            let Some(given) = given else { continue };
            if !apply(reader, given.at, limits, |limits| limits.with_joint_range(joint, min, max)) {
                break;
            }
        }
    }
    each(reader, speeds, limits, |limits| limits.joint_speeds, Limits::with_joint_speeds);
    each(reader, accelerations, limits, |limits| limits.joint_accelerations, Limits::with_joint_accelerations);
}

/// Applies six numbers one by one, so that an error stands at the one that is wrong.
fn each(
    reader: &mut Reader<'_>,
    given: Option<[Placed<f64>; 6]>,
    limits: &mut Limits,
    now: impl Fn(&Limits) -> [f64; 6],
    with: impl Fn(Limits, [f64; 6]) -> Result<Limits, InvalidLimit>,
) {
    for (index, given) in given.iter().flatten().enumerate() {
        let mut values = now(limits);
        values[index] = given.value;
        if !apply(reader, given.at, limits, |limits| with(limits, values)) {
            // One number for all six joints is wrong once.
            return;
        }
    }
}

/// Whether the limit made sense; else an error is reported at its place.
fn apply(
    reader: &mut Reader<'_>,
    at: usize,
    limits: &mut Limits,
    with: impl FnOnce(Limits) -> Result<Limits, InvalidLimit>,
) -> bool {
    match with(limits.clone()) {
        Ok(changed) => *limits = changed,
        Err(error) => {
            reader.error(at, error.to_string());
            return false;
        }
    }
    true
}

fn boxed(reader: &mut Reader<'_>, table: &Table<'_, '_>) -> Option<Result<Region, InvalidLimit>> {
    reader.keys(table, &["name", "of", "frame", "keep", "min_mm", "max_mm"]);
    let name = reader.required(table, "name", Reader::text);
    let keep = reader.choice(table, "keep", &[("inside", true), ("outside", false)]);
    let min = reader.required(table, "min_mm", Reader::three);
    let max = reader.required(table, "max_mm", Reader::three);
    let seen = seen(reader, table);
    let (name, min, max, (point, frame)) = (name?.value, min?.value, max?.value, seen?);
    let region = if keep? { Region::inside_box(name, min, max) } else { Region::outside_box(name, min, max) };
    Some(region.map(|region| region.of(point).seen_from(frame)))
}

fn half_space(reader: &mut Reader<'_>, table: &Table<'_, '_>) -> Option<Result<Region, InvalidLimit>> {
    reader.keys(table, &["name", "of", "frame", "point_mm", "inward"]);
    let name = reader.required(table, "name", Reader::text);
    let border = reader.required(table, "point_mm", Reader::three);
    let inward = reader.required(table, "inward", Reader::three);
    let (point, frame) = seen(reader, table)?;
    let region = Region::half_space(name?.value, border?.value, inward?.value);
    Some(region.map(|region| region.of(point).seen_from(frame)))
}

/// What a region is of, and from where it is seen. Both must be stated: neither goes without saying.
fn seen(reader: &mut Reader<'_>, table: &Table<'_, '_>) -> Option<(Point, RegionFrame)> {
    let points = [("tcp", Point::Tcp), ("elbow", Point::Elbow), ("wrist", Point::Wrist)];
    let point = reader.choice(table, "of", &points);
    let frame = reader.choice(table, "frame", &[("base", RegionFrame::ArmBase), ("user", RegionFrame::User)]);
    Some((point?, frame?))
}

fn add(
    reader: &mut Reader<'_>,
    table: &Table<'_, '_>,
    region: Option<Result<Region, InvalidLimit>>,
    limits: &mut Limits,
) {
    if let Some(region) = region {
        apply(reader, table.at, limits, |limits| limits.with_region(region?));
    }
}

/// The name of a table for messages.
fn named(kind: &str, table: &DeTable<'_>) -> String {
    match table.get("name").map(Spanned::get_ref) {
        Some(DeValue::String(name)) => format!("{kind} `{name}`"),
        _ => kind.to_owned(),
    }
}
