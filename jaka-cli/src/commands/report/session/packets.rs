//! Values of status packets over time.

mod changes;
mod speeds;

use std::collections::{BTreeMap, BTreeSet};
use std::time::Duration;

use jaka_dynamic::Node;
use jaka_sync::recording::Recording;
use jaka_sync::status::RobotStatus;
use serde_json::Value;

use self::changes::Changes;
use self::speeds::Speeds;
use super::happenings::{self, Happening};
use crate::packets::fields::{Field, Kind};
use crate::packets::packed_status::own_fields;
use crate::plots::Series;
use crate::recordings::recorded::{RecordedPacket, packets};

/// Greatest number drawn; no arm has greater ones.
const GREATEST: f64 = 1e6;
/// Smallest time between packets that interrupts a series.
const LEAST_GAP: Duration = Duration::from_millis(500);

/// Values of status packets over time.
#[derive(Debug, Default)]
pub(in crate::commands::report) struct Packets {
    pub(in crate::commands::report) count: usize,
    /// Number of messages of the status port that are not packets.
    pub(in crate::commands::report) unreadable: usize,
    /// Number of values not drawn, since no arm has such values.
    pub(in crate::commands::report) undrawn: usize,
    /// Longest time without a packet, in seconds.
    pub(in crate::commands::report) longest_gap: f64,
    /// Joint positions, in deg.
    pub(in crate::commands::report) joints: [Series; 6],
    /// Joint speeds, in deg/s.
    pub(in crate::commands::report) speeds: Speeds,
    /// Speed of the tool centre point, in mm/s.
    pub(in crate::commands::report) tcp_speed: Series,
    /// Curves of x, y and z, in mm.
    pub(in crate::commands::report) tcp: Vec<Vec<[f64; 3]>>,
    /// On/off states, by name.
    pub(in crate::commands::report) state: BTreeMap<&'static str, Series>,
    /// Digital and analog inputs and outputs, by name and index.
    pub(in crate::commands::report) digital: BTreeMap<(&'static str, usize), Series>,
    pub(in crate::commands::report) analog: BTreeMap<(&'static str, usize), Series>,
    /// Numbers and truth values of fields that packs add or change, by their paths.
    pub(in crate::commands::report) packed: BTreeMap<String, Packed>,
}

/// Values over time of a field that packs add or change.
#[derive(Debug)]
pub(in crate::commands::report) struct Packed {
    pub(in crate::commands::report) field: Field,
    pub(in crate::commands::report) series: Series,
}

impl Packets {
    /// Reads the packets. Also returns the events that they show.
    pub(super) fn read(recording: &Recording) -> (Self, Vec<Happening>) {
        let mut all: Vec<_> = packets(recording).collect();
        all.sort_by_key(|packet| packet.time);
        let gap = gap(&all);
        let (mut this, mut changes, own_fields) = (Self::default(), Changes::default(), own_fields());
        let mut last: Option<Duration> = None;
        for packet in all {
            let time = packet.time;
            match &packet.status {
                Ok(status) => {
                    this.follow(last, time, gap, &mut changes);
                    last = Some(time);
                    this.add(time.as_secs_f64(), &status.status);
                    changes.see(time, status);
                    if !own_fields.is_empty() {
                        this.add_packed(time, &own_fields, &status.own(), &mut changes);
                    }
                }
                Err(error) => {
                    this.unreadable += 1;
                    changes.unreadable(time, error);
                }
            }
        }
        this.interrupt(last);
        (this, changes.happenings)
    }

    /// Takes the time of a packet after another one. A long time between them interrupts the series, and is a problem.
    fn follow(&mut self, last: Option<Duration>, time: Duration, gap: Duration, changes: &mut Changes) {
        let Some(last) = last else { return };
        let without = time.saturating_sub(last);
        self.longest_gap = self.longest_gap.max(without.as_secs_f64());
        if without > gap {
            self.interrupt(Some(last));
            let what = format!("no status packet for {:.3} s", without.as_secs_f64());
            changes.happenings.push(Happening::wrong(last, happenings::HappeningKind::Packets, what));
        }
    }

    /// Interrupts the series after a packet: between two distant packets, the values are unknown.
    fn interrupt(&mut self, last: Option<Duration>) {
        let Some(last) = last.map(|last| last.as_secs_f64()) else { return };
        self.joints.iter_mut().chain([&mut self.tcp_speed]).for_each(|series| series.push(last, None));
        self.speeds.interrupt(last);
        self.tcp.push(Vec::new());
        let levels = self.digital.values_mut().chain(self.analog.values_mut()).chain(self.state.values_mut());
        let packed = self.packed.values_mut().map(|packed| &mut packed.series);
        levels.chain(packed).for_each(|series| series.interrupt(last));
    }

    fn add(&mut self, time: f64, status: &RobotStatus) {
        self.count += 1;
        let joints = status.joint_actual_position.map(|joints| joints.0);
        let drawn = joints.map(|joints| joints.map(|joint| self.drawn(joint)));
        for (at, series) in self.joints.iter_mut().enumerate() {
            series.push(time, drawn.and_then(|joints| joints[at]));
        }
        self.speeds.see(time, joints.filter(|joints| joints.iter().all(|joint| joint.abs() <= GREATEST)));
        let speed = status.tcp_speed.and_then(|speed| self.drawn(speed));
        self.tcp_speed.push(time, speed);
        self.add_pose(status.actual_position.map(|pose| [pose.x, pose.y, pose.z]));
        for (name, value) in state(status) {
            self.state.entry(name).or_default().push_change(time, value.map(level));
        }
        for (name, values) in digital(status) {
            let values = values.into_iter().flatten().map(|value| Some(level(*value)));
            add_list(&mut self.digital, name, time, values);
        }
        for (name, values) in analog(status) {
            let values: Vec<_> = values.into_iter().flatten().map(|value| self.drawn(*value)).collect();
            add_list(&mut self.analog, name, time, values);
        }
    }

    /// Adds the fields of packs: numbers and truth values are drawn, and changes of others are events.
    fn add_packed(&mut self, time: Duration, fields: &[Field], own: &Node<'_>, changes: &mut Changes) {
        let mut rest: BTreeSet<_> = self.packed.keys().cloned().collect();
        for field in fields.iter().flat_map(|field| field.clone().leaves(own)) {
            let value = field.named_value(own);
            rest.remove(&field.name);
            let number = match (field.kind(), &value) {
                (Kind::Truth, Some(Value::Bool(is_on))) => Some(level(*is_on)),
                (Kind::Number, Some(Value::Number(number))) => number.as_f64().and_then(|number| self.drawn(number)),
                (Kind::Other, Some(value)) => {
                    changes.see_value(time, &field.name, value);
                    continue;
                }
                _ => None,
            };
            let new = || Packed { field: field.clone(), series: Series::default() };
            let packed = self.packed.entry(field.name.clone()).or_insert_with(new);
            packed.series.push_change(time.as_secs_f64(), number);
        }
        let gone = self.packed.iter_mut().filter(|(name, _)| rest.contains(*name));
        gone.for_each(|(_, packed)| packed.series.interrupt(time.as_secs_f64()));
    }

    fn add_pose(&mut self, position: Option<[f64; 3]>) {
        let drawn = position.filter(|position| position.iter().all(|value| value.abs() <= GREATEST));
        self.undrawn += usize::from(position.is_some() && drawn.is_none());
        match (drawn, self.tcp.last_mut()) {
            (Some(position), Some(curve)) => curve.push(position),
            (Some(position), None) => self.tcp.push(vec![position]),
            (None, Some(curve)) if !curve.is_empty() => self.tcp.push(Vec::new()),
            (None, _) => {}
        }
    }

    fn drawn(&mut self, value: f64) -> Option<f64> {
        let drawn = Some(value).filter(|value| value.abs() <= GREATEST);
        self.undrawn += usize::from(drawn.is_none());
        drawn
    }
}

/// Adds the elements of a list; missing elements are unknown.
fn add_list(
    all: &mut BTreeMap<(&'static str, usize), Series>,
    name: &'static str,
    time: f64,
    values: impl IntoIterator<Item = Option<f64>>,
) {
    let mut length = 0;
    for value in values {
        all.entry((name, length)).or_default().push_change(time, value);
        length += 1;
    }
    all.range_mut((name, length)..=(name, usize::MAX)).for_each(|(_, series)| series.interrupt(time));
}

/// Returns the time without packets that counts as a gap: five times the usual period, and at least half a second.
fn gap(packets: &[RecordedPacket]) -> Duration {
    let mut periods: Vec<_> = packets.windows(2).map(|pair| pair[1].time.saturating_sub(pair[0].time)).collect();
    periods.sort_unstable();
    periods.get(periods.len() / 2).map_or(LEAST_GAP, |period| period.saturating_mul(5).max(LEAST_GAP))
}

fn level(is_on: bool) -> f64 {
    f64::from(u8::from(is_on))
}

fn state(status: &RobotStatus) -> [(&'static str, Option<bool>); 7] {
    [
        ("powered_on", status.powered_on),
        ("enabled", status.enabled),
        ("in_position", status.in_position),
        ("drag_status", status.drag_status),
        ("paused", status.paused),
        ("protective_stop", status.protective_stop),
        ("emergency_stop", status.emergency_stop),
    ]
}

fn digital(status: &RobotStatus) -> [(&'static str, Option<&Vec<bool>>); 4] {
    [
        ("digital_inputs", status.digital_inputs.as_ref()),
        ("digital_outputs", status.digital_outputs.as_ref()),
        ("tool_digital_inputs", status.tool_digital_inputs.as_ref()),
        ("tool_digital_outputs", status.tool_digital_outputs.as_ref()),
    ]
}

fn analog(status: &RobotStatus) -> [(&'static str, Option<&Vec<f64>>); 3] {
    [
        ("analog_inputs", status.analog_inputs.as_ref()),
        ("analog_outputs", status.analog_outputs.as_ref()),
        ("tool_analog_inputs", status.tool_analog_inputs.as_ref()),
    ]
}
