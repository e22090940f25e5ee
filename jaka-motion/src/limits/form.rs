//! Limits as serde's data, in the tables and keys of a file.

use jaka_proto::messages::kinematics::{GetDhParamReply, literal};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::region::Shape;
use super::{InvalidLimit, Limits, Preset, Region, RegionFrame};
use crate::model::{Model, Point};

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
    min_deg: Option<[f64; 6]>,
    max_deg: Option<[f64; 6]>,
    speed_deg_s: Option<[f64; 6]>,
    acceleration_deg_s2: Option<[f64; 6]>,
    jerk_deg_s3: Option<[f64; 6]>,
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
    joint_acceleration_deg_s2: Option<[f64; 6]>,
    joint_jerk_deg_s3: Option<[f64; 6]>,
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
    min_mm: [f64; 3],
    max_mm: [f64; 3],
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
    point_mm: [f64; 3],
    inward: [f64; 3],
}

impl Serialize for Limits {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Form::from(self).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Limits {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Form::deserialize(deserializer)?.limits()
    }
}

impl From<&Limits> for Form {
    fn from(limits: &Limits) -> Self {
        let (model, axes) = (&limits.model, &limits.axes);
        let mut form = Self {
            model: model.name().to_owned(),
            dh: (Model::named(model.name()) != Some(model)).then(|| Dh::from(model)),
            preset: Some(limits.preset),
            joints: Joints {
                min_deg: Some(axes.min),
                max_deg: Some(axes.max),
                speed_deg_s: Some(axes.speeds),
                acceleration_deg_s2: Some(axes.accelerations),
                jerk_deg_s3: Some(axes.jerks),
            },
            tcp: Tcp { speed_mm_s: limits.tcp_speed, acceleration_mm_s2: limits.tcp_acceleration },
            stop: Stop {
                joint_acceleration_deg_s2: Some(axes.stop_accelerations),
                joint_jerk_deg_s3: Some(axes.stop_jerks),
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
                let (point_mm, inward) = (border.coords.into(), inward.into_inner().into());
                self.half_space.push(HalfSpace { name, of, frame, point_mm, inward });
                return;
            }
        };
        let (min_mm, max_mm) = (min.coords.into(), max.coords.into());
        self.boxes.push(BoxForm { name, of, frame, keep, min_mm, max_mm });
    }

    fn limits<E: Error>(self) -> Result<Limits, E> {
        let model = Model::named(&self.model).ok_or_else(|| E::custom(format!("there is no arm `{}`", self.model)))?;
        let limits = match &self.dh {
            Some(dh) => Limits::of(&model.with_dh(&dh.reply()).map_err(E::custom)?),
            None => Limits::of(model),
        };
        self.over(limits).map_err(E::custom)
    }

    /// These over the published ones and the defaults. An acceleration has a jerk of its own, and goes before it.
    fn over(self, published: Limits) -> Result<Limits, InvalidLimit> {
        let Self { joints, tcp, stop, singularity, .. } = self;
        let mut limits = apply(published, self.preset, |limits, preset| Ok(limits.with_preset(preset)))?;
        let (min, max) = (joints.min_deg.unwrap_or(limits.axes.min), joints.max_deg.unwrap_or(limits.axes.max));
        for (joint, (min, max)) in (1..).zip(min.into_iter().zip(max)) {
            limits = limits.with_joint_range(joint, min, max)?;
        }
        limits = apply(limits, joints.speed_deg_s, Limits::with_joint_speeds)?;
        limits = apply(limits, joints.acceleration_deg_s2, Limits::with_joint_accelerations)?;
        limits = apply(limits, joints.jerk_deg_s3, Limits::with_joint_jerks)?;
        limits = apply(limits, tcp.speed_mm_s, Limits::with_tcp_speed)?;
        limits = apply(limits, tcp.acceleration_mm_s2, Limits::with_tcp_acceleration)?;
        limits = apply(limits, stop.joint_acceleration_deg_s2, Limits::with_stop_accelerations)?;
        limits = apply(limits, stop.joint_jerk_deg_s3, Limits::with_stop_jerks)?;
        limits = apply(limits, stop.tcp_acceleration_mm_s2, |limits, bound| match bound {
            Some(bound) => limits.with_stop_tcp_acceleration(bound),
            None => Ok(limits.without_stop_tcp_acceleration()),
        })?;
        limits = apply(limits, singularity.least_distance, Limits::with_singularity_distance)?;
        let boxes = self.boxes.into_iter().map(BoxForm::region);
        boxes
            .chain(self.half_space.into_iter().map(HalfSpace::region))
            .try_fold(limits, |limits, region| limits.with_region(region?))
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
    fn reply(&self) -> GetDhParamReply {
        let Self { alpha_deg: alpha, a_mm: a, d_mm: d, joint_home_offset_deg: joint_home_offset } = *self;
        literal::GetDhParamReply { alpha, a, d, joint_home_offset }.into()
    }
}

impl BoxForm {
    fn region(self) -> Result<Region, InvalidLimit> {
        let region = match self.keep {
            Keep::Inside => Region::inside_box(self.name, self.min_mm, self.max_mm),
            Keep::Outside => Region::outside_box(self.name, self.min_mm, self.max_mm),
        };
        Ok(region?.of(self.of).seen_from(self.frame))
    }
}

impl HalfSpace {
    fn region(self) -> Result<Region, InvalidLimit> {
        let region = Region::half_space(self.name, self.point_mm, self.inward)?;
        Ok(region.of(self.of).seen_from(self.frame))
    }
}

/// Changes limits by a value that is given.
fn apply<T>(
    limits: Limits,
    given: Option<T>,
    with: impl FnOnce(Limits, T) -> Result<Limits, InvalidLimit>,
) -> Result<Limits, InvalidLimit> {
    match given {
        Some(value) => with(limits, value),
        None => Ok(limits),
    }
}

/// A key that is there, `null` or not.
#[expect(clippy::option_option, reason = "absent and null are different")]
fn given<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Option<f64>>, D::Error> {
    Option::deserialize(deserializer).map(Some)
}
