//! Limits from a TOML file.

mod table;

use self::table::{Placed, Table, read_file};
use super::{InvalidLimit, Limits, Preset, Region, RegionFrame};
use crate::model::{Model, Point};
use crate::text_file::{FileErrors, nearest};

/// Reads a file: see [`Limits::from_toml`].
pub(super) fn read(text: &str, file_name: &str) -> Result<Limits, FileErrors> {
    read_file((text, file_name), limits)
}

/// Reads the limits of a file. Without a model, which is an error, it reads the rest for its errors.
fn limits(file: &Table<'_, '_>) -> Limits {
    let model = model(file);
    let mut limits = model.map_or_else(|| Limits::of(&Model::default()), Limits::of);
    let presets = [Preset::Gentle, Preset::Usual, Preset::Quick].map(|preset| (preset.name(), preset));
    if let Some(preset) = optional_choice(file, "preset", &presets) {
        limits = limits.with_preset(preset);
    }
    joints(file, model.is_some(), &mut limits);
    if let Some(tcp) = file.table("tcp") {
        if let Some(speed) = tcp.number("speed_mm_s") {
            apply(file, speed.at, &mut limits, |limits| limits.with_tcp_speed(speed.value));
        }
        if let Some(most) = tcp.number("acceleration_mm_s2") {
            apply(file, most.at, &mut limits, |limits| limits.with_tcp_acceleration(most.value));
        }
        tcp.finish();
    }
    stops(file, &mut limits);
    if let Some(singularity) = file.table("singularity") {
        if let Some(least) = singularity.number("least_distance") {
            apply(file, least.at, &mut limits, |limits| limits.with_singularity_distance(least.value));
        }
        singularity.finish();
    }
    let boxes = file.tables("box", "box").into_iter().map(|table| (boxed(&table), table));
    let half_spaces = file.tables("half_space", "half_space").into_iter().map(|table| (half_space(&table), table));
    for (region, table) in boxes.chain(half_spaces) {
        if let Some(region) = region {
            apply(file, table.at, &mut limits, |limits| limits.with_region(region?));
        }
        table.finish();
    }
    limits
}

fn model(file: &Table<'_, '_>) -> Option<&'static Model> {
    file.require("model");
    let name = file.text("model")?;
    let model = Model::named(name.value);
    if model.is_none() {
        let names = Model::published().iter().map(Model::name);
        let hint = match nearest(name.value, names.clone()) {
            Some(near) => format!("is it `{near}`?"),
            None => format!("the arms are {}", names.collect::<Vec<_>>().join(", ")),
        };
        file.error(name.at, &format!("there is no arm `{}`; {hint}", name.value));
    }
    model
}

/// Reads the limits of joints. Compares ranges and speeds with the model's, if it is known.
fn joints(file: &Table<'_, '_>, known: bool, limits: &mut Limits) {
    let Some(table) = file.table("joints") else { return };
    let keys = ["min_deg", "max_deg", "speed_deg_s", "acceleration_deg_s2", "jerk_deg_s3"];
    let [min, max, speeds, accelerations, jerks] = keys.map(|key| six(&table, key));
    table.finish();
    if !known {
        return;
    }
    for joint in 1..=6 {
        let [low, high] = [min, max].map(|given| given.map(|given| given[joint - 1]));
        let low_deg = low.map_or(limits.axes.min[joint - 1], |low| low.value);
        let high_deg = high.map_or(limits.axes.max[joint - 1], |high| high.value);
        // Each end is checked alone first, so that an error is at the wrong one.
        let ends = [(low, low_deg, low_deg), (high, high_deg, high_deg), (low.or(high), low_deg, high_deg)];
        for (given, min, max) in ends {
            let Some(given) = given else { continue };
            if !apply(file, given.at, limits, |limits| limits.with_joint_range(joint, min, max)) {
                break;
            }
        }
    }
    each(file, speeds.as_ref(), limits, |limits| limits.axes.speeds, Limits::with_joint_speeds);
    each(file, accelerations.as_ref(), limits, |limits| limits.axes.accelerations, Limits::with_joint_accelerations);
    each(file, jerks.as_ref(), limits, |limits| limits.axes.jerks, Limits::with_joint_jerks);
}

fn stops(file: &Table<'_, '_>, limits: &mut Limits) {
    let Some(table) = file.table("stop") else { return };
    let accelerations = six(&table, "joint_acceleration_deg_s2");
    each(
        file,
        accelerations.as_ref(),
        limits,
        |limits| limits.axes.stop_accelerations,
        Limits::with_stop_accelerations,
    );
    let jerks = six(&table, "joint_jerk_deg_s3");
    each(file, jerks.as_ref(), limits, |limits| limits.axes.stop_jerks, Limits::with_stop_jerks);
    if let Some(tcp) = table.number("tcp_acceleration_mm_s2") {
        apply(file, tcp.at, limits, |limits| limits.with_stop_tcp_acceleration(tcp.value));
    }
    table.finish();
}

fn six(table: &Table<'_, '_>, key: &'static str) -> Option<Six> {
    table.numbers(key, "a finite number, or a list of six", |one| Some([one; 6]))
}

/// Number for each joint.
type Six = [Placed<f64>; 6];

/// Applies six numbers one by one, so that an error is at the wrong one.
fn each(
    file: &Table<'_, '_>,
    given: Option<&Six>,
    limits: &mut Limits,
    now: impl Fn(&Limits) -> [f64; 6],
    with: impl Fn(Limits, [f64; 6]) -> Result<Limits, InvalidLimit>,
) {
    for (index, given) in given.into_iter().flatten().enumerate() {
        let mut values = now(limits);
        values[index] = given.value;
        if !apply(file, given.at, limits, |limits| with(limits, values)) {
            // A single number for all six joints gives a single error.
            return;
        }
    }
}

/// Applies a limit; if it is invalid, reports an error at its place and returns false.
fn apply(
    file: &Table<'_, '_>,
    at: usize,
    limits: &mut Limits,
    with: impl FnOnce(Limits) -> Result<Limits, InvalidLimit>,
) -> bool {
    match with(limits.clone()) {
        Ok(changed) => *limits = changed,
        Err(error) => {
            file.error(at, &error.to_string());
            return false;
        }
    }
    true
}

fn boxed(table: &Table<'_, '_>) -> Option<Result<Region, InvalidLimit>> {
    let name = name(table);
    let keep = choice(table, "keep", &[("inside", true), ("outside", false)]);
    let (min, max) = (three(table, "min_mm"), three(table, "max_mm"));
    let seen = seen(table);
    let (name, min, max, (point, frame)) = (name?, min?, max?, seen?);
    let region = if keep? { Region::inside_box(name, min, max) } else { Region::outside_box(name, min, max) };
    Some(region.map(|region| region.of(point).seen_from(frame)))
}

fn half_space(table: &Table<'_, '_>) -> Option<Result<Region, InvalidLimit>> {
    let name = name(table);
    let (border, inward) = (three(table, "point_mm"), three(table, "inward"));
    let (point, frame) = seen(table)?;
    let region = Region::half_space(name?, border?, inward?);
    Some(region.map(|region| region.of(point).seen_from(frame)))
}

fn name(table: &Table<'_, '_>) -> Option<String> {
    table.require("name");
    table.text("name").map(|name| name.value.to_owned())
}

/// Reads the point that a region is for and the frame from which it is seen. Both are required.
fn seen(table: &Table<'_, '_>) -> Option<(Point, RegionFrame)> {
    let point = choice(table, "of", &[("tcp", Point::Tcp), ("elbow", Point::Elbow), ("wrist", Point::Wrist)]);
    let frame = choice(table, "frame", &[("base", RegionFrame::ArmBase), ("user", RegionFrame::User)]);
    Some((point?, frame?))
}

fn three(table: &Table<'_, '_>, key: &'static str) -> Option<[f64; 3]> {
    table.require(key);
    let numbers = table.numbers(key, "a list of three finite numbers", |_| None)?;
    Some(numbers.map(|number| number.value))
}

/// Reads a required key whose value is one of these words.
fn choice<T: Copy>(table: &Table<'_, '_>, key: &'static str, words: &[(&str, T)]) -> Option<T> {
    table.require(key);
    optional_choice(table, key, words)
}

/// Reads a key whose value is one of these words, if the key is there.
fn optional_choice<T: Copy>(table: &Table<'_, '_>, key: &'static str, words: &[(&str, T)]) -> Option<T> {
    let text = table.text(key)?;
    let found = words.iter().find(|(word, _)| *word == text.value).map(|(_, value)| *value);
    if found.is_none() {
        let words: Vec<_> = words.iter().map(|(word, _)| format!("\"{word}\"")).collect();
        table.error(text.at, &format!("`{key}` must be {}", words.join(" or ")));
    }
    found
}
