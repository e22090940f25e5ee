//! Measurements in the cabinet, the joints and the torque sensor. The protocol's document states no units for them.

use jaka_sync::proto::wire::Typed;
use jaka_sync::status::{JointMonitor, RobotStatus};
use ratatui::text::{Line, Span};

use super::joints::measured;
use super::style::{self, number};
use crate::packets::value_rows::Row;
use crate::terminal::output::ABSENT;

/// Widths of the names of rows, and of the columns after them.
const NAME: usize = 20;
const COLUMN: usize = 9;

/// Row: its name, and a joint's value.
type JointRow = (&'static str, fn(&JointMonitor) -> f64);

const ROWS: [JointRow; 10] = [
    ("current", |joint| joint.current),
    ("voltage", |joint| joint.voltage),
    ("temperature", |joint| joint.temperature),
    ("average power", |joint| joint.average_power),
    ("current fluctuation", |joint| joint.current_fluctuation),
    ("torque", |joint| joint.torque),
    ("revolutions", |joint| joint.total_revolutions),
    ("running time", |joint| joint.total_running_time),
    ("cycles since start", |joint| joint.cycles_since_start),
    ("time since start", |joint| joint.running_time_since_start),
];

/// Returns the lines of all measurements.
pub(super) fn lines(status: &RobotStatus, packed: &[Row], width: u16) -> Vec<Line<'static>> {
    let mut lines = vec![style::rule("Joints (no units stated by the protocol)", width), heading()];
    lines.push(row("position °", status.joint_actual_position.map(|joints| joints.0)));
    lines.push(row("commanded °", status.joint_commanded_position.map(|joints| joints.0)));
    let joints = measured(status);
    for (name, value) in ROWS {
        let of = |index: usize| joints.and_then(|joints| joints.get(index)).map(value);
        lines.push(cells(name, (0..6).map(of)));
    }
    lines.push(style::rule("TCP", width));
    lines.push(Line::styled(columns(["x mm", "y mm", "z mm", "rx °", "ry °", "rz °"]), style::faint()));
    lines.push(row("pose", status.actual_position.map(<[f64; 6]>::from)));
    lines.push(row("commanded", status.commanded_position.map(<[f64; 6]>::from)));
    lines.push(style::rule("Cabinet", width));
    lines.extend(cabinet(status));
    lines.push(style::rule("Torque sensor", width));
    lines.extend(torque_sensor(status));
    if !packed.is_empty() {
        lines.push(style::rule("Of packs", width));
        lines.extend(packed.iter().map(|(name, value)| named(name, vec![Span::raw(format!(" {value}"))])));
    }
    lines
}

fn heading() -> Line<'static> {
    Line::styled(columns(["1", "2", "3", "4", "5", "6"]), style::faint())
}

fn columns(names: [&str; 6]) -> String {
    let cells = names.map(|name| format!("{name:>COLUMN$}"));
    format!(" {:NAME$}{}", "", cells.concat())
}

fn cabinet(status: &RobotStatus) -> [Line<'static>; 4] {
    let data = status.monitor_data.as_ref().and_then(Typed::known);
    let version =
        data.map(|data| format!("{:>COLUMN$}", format!("{}.{}", data.scb_major_version, data.scb_minor_version)));
    [
        cells("temperature", [data.map(|data| data.cabinet_temperature)].into_iter()),
        cells("bus power", [data.map(|data| data.bus_average_power)].into_iter()),
        cells("bus current", [data.map(|data| data.bus_average_current)].into_iter()),
        named("SCB version", vec![Span::raw(version.unwrap_or_else(|| format!("{ABSENT:>COLUMN$}")))]),
    ]
}

fn torque_sensor(status: &RobotStatus) -> [Line<'static>; 3] {
    let state = status.torque_sensor.as_ref().and_then(Typed::known).map(|sensor| &sensor.state);
    let works = state.map_or(ABSENT, |state| if state.working { "yes" } else { "no" });
    [
        named("works", vec![Span::raw(format!("{works:>COLUMN$}"))]),
        row("contact force", state.map(|state| state.contact_force)),
        row("raw reading", state.map(|state| state.raw_reading)),
    ]
}

fn row(name: &str, values: Option<[f64; 6]>) -> Line<'static> {
    cells(name, (0..6).map(|index| values.map(|values| values[index])))
}

fn cells(name: &str, values: impl Iterator<Item = Option<f64>>) -> Line<'static> {
    named(name, values.map(|value| number(value, COLUMN, 2)).collect())
}

fn named(name: &str, mut values: Vec<Span<'static>>) -> Line<'static> {
    values.insert(0, Span::styled(format!(" {name:<NAME$}"), style::faint()));
    Line::from(values)
}
