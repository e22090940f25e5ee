//! Limits as serde's data and as TOML, in the same tables and keys.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::region::Shape;
use super::{InvalidLimit, Limits, Preset, Region, RegionFrame};
use crate::links::Links;
use crate::model::{Model, Point};
#[cfg(feature = "toml")]
use crate::text_file::{FileErrors, Report};

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Form {
    model: String,
    /// Parameters of the controller, where they are not the published ones.
    #[serde(skip_serializing_if = "Option::is_none")]
    dh: Option<Dh>,
    preset: Option<Preset>,
    #[serde(default)]
    joints: Joints,
    #[serde(default)]
    tcp: Tcp,
    #[serde(default)]
    stop: Stop,
    #[serde(default)]
    singularity: Singularity,
    #[serde(default, rename = "box")]
    boxes: Vec<BoxForm>,
    #[serde(default)]
    half_space: Vec<HalfSpace>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Dh {
    alpha_deg: [f64; 6],
    a_mm: [f64; 6],
    d_mm: [f64; 6],
    joint_home_offset_deg: [f64; 6],
}

#[derive(Serialize, Deserialize, Default)]
#[serde(deny_unknown_fields)]
struct Joints {
    min_deg: Option<Six>,
    max_deg: Option<Six>,
    speed_deg_s: Option<Six>,
    acceleration_deg_s2: Option<Six>,
    jerk_deg_s3: Option<Six>,
}

#[derive(Serialize, Deserialize, Default)]
#[serde(deny_unknown_fields)]
struct Tcp {
    speed_mm_s: Option<f64>,
    acceleration_mm_s2: Option<f64>,
}

#[derive(Serialize, Deserialize, Default)]
#[serde(deny_unknown_fields)]
struct Stop {
    joint_acceleration_deg_s2: Option<Six>,
    joint_jerk_deg_s3: Option<Six>,
    /// The outer one is none for the default, the inner one for stops that the joints alone bound.
    #[expect(clippy::option_option, reason = "absent and null are different")]
    #[serde(default, deserialize_with = "given")]
    tcp_acceleration_mm_s2: Option<Option<f64>>,
}

#[derive(Serialize, Deserialize, Default)]
#[serde(deny_unknown_fields)]
struct Singularity {
    least_distance: Option<f64>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct BoxForm {
    name: String,
    of: Point,
    frame: RegionFrame,
    keep: Keep,
    min_mm: Three,
    max_mm: Three,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Keep {
    Inside,
    Outside,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct HalfSpace {
    name: String,
    of: Point,
    frame: RegionFrame,
    point_mm: Three,
    inward: Three,
}

/// Number for each joint.
#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(from = "OneOrSix")]
struct Six([f64; 6]);

#[derive(Deserialize)]
#[serde(untagged, expecting = "expected a number, or a list of six")]
enum OneOrSix {
    One(f64),
    Six([f64; 6]),
}

#[derive(Serialize, Deserialize)]
#[serde(try_from = "Vec<f64>")]
struct Three([f64; 3]);

/// Limits as far as they could be read, and the errors of values with their places.
struct Reading {
    limits: Limits,
    wrong: Vec<(Place, String)>,
}

/// Place of a value.
#[derive(Clone, Copy)]
#[cfg_attr(not(feature = "toml"), expect(dead_code, reason = "only a file has places"))]
enum Place {
    Key(&'static str),
    KeyOf(&'static str, &'static str),
    Element(&'static str, usize),
}

impl Serialize for Limits {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Form::from(self).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Limits {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Reading { limits, wrong } = Form::deserialize(deserializer)?.read();
        wrong.into_iter().next().map_or(Ok(limits), |(_, message)| Err(D::Error::custom(message)))
    }
}

/// Reads a file: see [`Limits::from_toml`].
#[cfg(feature = "toml")]
pub(super) fn from_toml(text: &str, file_name: &str) -> Result<Limits, FileErrors> {
    let mut report = Report::new(text, file_name);
    let (file, errors) = toml::de::DeTable::parse_recoverable(text);
    let at = |error: &toml::de::Error| error.span().map_or(0, |span| span.start);
    if !errors.is_empty() {
        for error in errors {
            report.error(at(&error), format!("not valid TOML: {}", error.message()));
        }
        return report.finish(Limits::of(&Model::default()));
    }
    let form = Form::deserialize(toml::de::Deserializer::from(file.clone()));
    let Reading { limits, wrong } = form.map_or_else(
        |error| {
            // Its text is what happened, and the key in a second line.
            report.error(at(&error), error.to_string().trim_end().replace('\n', " "));
            Reading { limits: Limits::of(&Model::default()), wrong: Vec::new() }
        },
        Form::read,
    );
    for (place, message) in wrong {
        let value = match place {
            Place::Key(key) => file.get_ref().get(key),
            Place::KeyOf(table, key) => file.get_ref().get(table).and_then(|table| table.get_ref().get(key)),
            Place::Element(list, index) => file.get_ref().get(list).and_then(|list| list.get_ref().get(index)),
        };
        report.error(value.map_or(0, |value| value.span().start), message);
    }
    report.finish(limits)
}

impl From<&Limits> for Form {
    fn from(limits: &Limits) -> Self {
        let (model, axes) = (&limits.model, &limits.axes);
        let mut form = Self {
            model: model.name().to_owned(),
            dh: (Model::named(model.name()) != Some(model)).then(|| Dh::from(model)),
            preset: Some(limits.preset),
            joints: Joints {
                min_deg: Some(Six(axes.min)),
                max_deg: Some(Six(axes.max)),
                speed_deg_s: Some(Six(axes.speeds)),
                acceleration_deg_s2: Some(Six(axes.accelerations)),
                jerk_deg_s3: Some(Six(axes.jerks)),
            },
            tcp: Tcp { speed_mm_s: limits.tcp_speed, acceleration_mm_s2: limits.tcp_acceleration },
            stop: Stop {
                joint_acceleration_deg_s2: Some(Six(axes.stop_accelerations)),
                joint_jerk_deg_s3: Some(Six(axes.stop_jerks)),
                tcp_acceleration_mm_s2: Some(limits.stop_tcp_acceleration),
            },
            singularity: Singularity { least_distance: Some(limits.clearance.0) },
            boxes: Vec::new(),
            half_space: Vec::new(),
        };
        limits.regions.iter().for_each(|region| form.add(region));
        form
    }
}

impl Form {
    fn add(&mut self, region: &Region) {
        let (name, of, frame) = (region.name().to_string(), region.point(), region.frame());
        let (keep, min, max) = match region.shape() {
            Shape::Inside { min, max } => (Keep::Inside, min, max),
            Shape::Outside { min, max } => (Keep::Outside, min, max),
            Shape::HalfSpace { border, inward } => {
                let (point_mm, inward) = (Three(border.coords.into()), Three(inward.into_inner().into()));
                self.half_space.push(HalfSpace { name, of, frame, point_mm, inward });
                return;
            }
        };
        let (min_mm, max_mm) = (Three(min.coords.into()), Three(max.coords.into()));
        self.boxes.push(BoxForm { name, of, frame, keep, min_mm, max_mm });
    }

    /// Reads these over the published ones and the defaults. An acceleration has a jerk of its own, and goes before it.
    fn read(self) -> Reading {
        let Self { model, dh, preset, joints, tcp, stop, singularity, boxes, half_space } = self;
        let mut reading = Reading { limits: Limits::of(&Model::default()), wrong: Vec::new() };
        let Some(named) = Model::named(&model) else {
            let names: Vec<_> = Model::published().iter().map(Model::name).collect();
            reading.wrong(Place::Key("model"), format!("there is no arm `{model}`; the arms are {}", names.join(", ")));
            return reading;
        };
        let adapted = dh.map_or_else(|| Ok(named.clone()), |dh| named.with_links(dh.links()));
        let adapted = adapted.map_err(|error| reading.wrong(Place::Key("dh"), error.to_string()));
        reading.limits = Limits::of(&adapted.unwrap_or_else(|()| named.clone()));
        reading.apply(Place::Key("preset"), preset, |limits, preset| Ok(limits.with_preset(preset)));
        reading.ranges(joints.min_deg, joints.max_deg);
        let six = [
            ("joints", "speed_deg_s", joints.speed_deg_s, Limits::with_joint_speeds as WithSix),
            ("joints", "acceleration_deg_s2", joints.acceleration_deg_s2, Limits::with_joint_accelerations),
            ("joints", "jerk_deg_s3", joints.jerk_deg_s3, Limits::with_joint_jerks),
            ("stop", "joint_acceleration_deg_s2", stop.joint_acceleration_deg_s2, Limits::with_stop_accelerations),
            ("stop", "joint_jerk_deg_s3", stop.joint_jerk_deg_s3, Limits::with_stop_jerks),
        ];
        for (table, key, given, with) in six {
            reading.apply(Place::KeyOf(table, key), given, |limits, Six(given)| with(limits, given));
        }
        reading.apply(Place::KeyOf("tcp", "speed_mm_s"), tcp.speed_mm_s, Limits::with_tcp_speed);
        reading.apply(Place::KeyOf("tcp", "acceleration_mm_s2"), tcp.acceleration_mm_s2, Limits::with_tcp_acceleration);
        let place = Place::KeyOf("stop", "tcp_acceleration_mm_s2");
        reading.apply(place, stop.tcp_acceleration_mm_s2, |limits, bound| match bound {
            Some(bound) => limits.with_stop_tcp_acceleration(bound),
            None => Ok(limits.without_stop_tcp_acceleration()),
        });
        let place = Place::KeyOf("singularity", "least_distance");
        reading.apply(place, singularity.least_distance, Limits::with_singularity_distance);
        for (index, region) in boxes.into_iter().enumerate() {
            reading.apply(Place::Element("box", index), Some(region.region()), |limits, region| {
                limits.with_region(region?)
            });
        }
        for (index, region) in half_space.into_iter().enumerate() {
            let place = Place::Element("half_space", index);
            reading.apply(place, Some(region.region()), |limits, region| limits.with_region(region?));
        }
        reading
    }
}

/// Setter of a number for each joint.
type WithSix = fn(Limits, [f64; 6]) -> Result<Limits, InvalidLimit>;

impl Reading {
    fn wrong(&mut self, place: Place, message: String) {
        self.wrong.push((place, message));
    }

    /// Changes limits by a value that is given.
    fn apply<T>(
        &mut self,
        place: Place,
        given: Option<T>,
        with: impl FnOnce(Limits, T) -> Result<Limits, InvalidLimit>,
    ) {
        match given.map(|given| with(self.limits.clone(), given)) {
            Some(Ok(limits)) => self.limits = limits,
            Some(Err(error)) => self.wrong(place, error.to_string()),
            None => {}
        }
    }

    fn ranges(&mut self, min: Option<Six>, max: Option<Six>) {
        let (least, most) = (self.limits.axes.min, self.limits.axes.max);
        let (lowest, highest) = (min.map_or(least, |min| min.0), max.map_or(most, |max| max.0));
        for (index, (low, high)) in lowest.into_iter().zip(highest).enumerate() {
            let range = |limits: Limits, (low, high)| limits.with_joint_range(index + 1, low, high);
            // An error is at the end that is wrong alone.
            let is_low = min.is_some() && range(self.limits.clone(), (low, most[index])).is_err();
            let key = if is_low { "min_deg" } else { "max_deg" };
            self.apply(Place::KeyOf("joints", key), Some((low, high)), range);
        }
    }
}

impl From<OneOrSix> for Six {
    fn from(given: OneOrSix) -> Self {
        match given {
            OneOrSix::One(all) => Self([all; 6]),
            OneOrSix::Six(each) => Self(each),
        }
    }
}

impl TryFrom<Vec<f64>> for Three {
    type Error = String;

    fn try_from(list: Vec<f64>) -> Result<Self, String> {
        list.try_into().map(Self).map_err(|list| format!("expected three numbers, found {}", list.len()))
    }
}

impl From<&Model> for Dh {
    fn from(model: &Model) -> Self {
        Self {
            alpha_deg: *model.alpha(),
            a_mm: *model.a(),
            d_mm: *model.d(),
            joint_home_offset_deg: *model.joint_home_offset(),
        }
    }
}

impl Dh {
    fn links(&self) -> Links {
        let Self { alpha_deg: alpha, a_mm: a, d_mm: d, joint_home_offset_deg: joint_home_offset } = *self;
        Links { alpha, a, d, joint_home_offset }
    }
}

impl BoxForm {
    fn region(self) -> Result<Region, InvalidLimit> {
        let region = match self.keep {
            Keep::Inside => Region::inside_box(self.name, self.min_mm.0, self.max_mm.0),
            Keep::Outside => Region::outside_box(self.name, self.min_mm.0, self.max_mm.0),
        };
        Ok(region?.of(self.of).seen_from(self.frame))
    }
}

impl HalfSpace {
    fn region(self) -> Result<Region, InvalidLimit> {
        let region = Region::half_space(self.name, self.point_mm.0, self.inward.0)?;
        Ok(region.of(self.of).seen_from(self.frame))
    }
}

/// A key that is there, `null` or not.
#[expect(clippy::option_option, reason = "absent and null are different")]
fn given<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Option<f64>>, D::Error> {
    Option::deserialize(deserializer).map(Some)
}
