//! Joint positions and the pose of the tool centre point.

use jaka_robot::proto::wire::Typed;
use jaka_robot::status::{JointMonitor, RobotStatus};
use ratatui::text::{Line, Span};

use super::style::{self, number};

/// Greatest rotation of a joint.
const TURN: f64 = 360.0;
/// Cells of a joint number, with a blank on both sides.
const NUMBER: usize = 3;
/// Cells of a joint's position.
const POSITION: usize = 10;
/// Width from which the columns of [`MORE`] are shown as well.
const WIDE: usize = 90;

/// Column: its title, width and decimals, and a joint's value.
type Column = (&'static str, usize, usize, fn(&JointMonitor) -> f64);

const MEASURED: [Column; 3] = [
    ("current", 8, 2, |joint| joint.current),
    ("torque", 7, 2, |joint| joint.torque),
    ("temp", 6, 1, |joint| joint.temperature),
];
const MORE: [Column; 2] = [("voltage", 8, 1, |joint| joint.voltage), ("power", 8, 1, |joint| joint.average_power)];

/// Names of a pose's six numbers.
const POSE: [&str; 6] = ["x", "y", "z", "rx", "ry", "rz"];

/// Returns a line for each joint, below their heading.
pub(super) fn lines(status: &RobotStatus, width: u16) -> Vec<Line<'static>> {
    let width = usize::from(width);
    let columns = if width < WIDE { MEASURED.to_vec() } else { [&MEASURED[..], &MORE].concat() };
    // One blank between the position and the bar, and another at the end of the line.
    let others = NUMBER + POSITION + 2 + columns.iter().map(|(_, width, ..)| width).sum::<usize>();
    // An odd number of cells has a middle one.
    let bar_width = width.saturating_sub(others).saturating_sub(1) | 1;
    let titles: Vec<_> = columns.iter().map(|(title, width, ..)| format!("{title:>width$}")).collect();
    let position = format!("{:>width$}", "position °", width = NUMBER + POSITION);
    let heading = format!("{position} {}{}", bar_heading(bar_width), titles.concat());
    let joints = (0..6).map(|index| joint(status, index, bar_width, &columns));
    std::iter::once(Line::styled(heading, style::faint())).chain(joints).collect()
}

fn joint(status: &RobotStatus, index: usize, bar_width: usize, columns: &[Column]) -> Line<'static> {
    let position = position(status, index);
    let measured = measured(status).and_then(|joints| joints.get(index));
    let number_of = Span::styled(format!(" {} ", index + 1), style::faint());
    let mut spans = vec![number_of, number(position, POSITION, 3), Span::raw(" ")];
    spans.extend(bar(position, bar_width));
    spans.extend(columns.iter().map(|(_, width, decimals, value)| number(measured.map(value), *width, *decimals)));
    Line::from(spans)
}

/// Returns only the positions, three joints a line.
pub(super) fn short_lines(status: &RobotStatus) -> Vec<Line<'static>> {
    short("J", ["1", "2", "3", "4", "5", "6"], |index| position(status, index))
}

fn position(status: &RobotStatus, index: usize) -> Option<f64> {
    status.joint_actual_position.map(|joints| joints.0[index])
}

/// Returns the measurements of the joints, if the packet has them in the known form.
pub(super) fn measured(status: &RobotStatus) -> Option<&[JointMonitor]> {
    status.monitor_data.as_ref().and_then(Typed::known).map(|data| &*data.joints)
}

fn bar_heading(width: usize) -> String {
    if width < 13 {
        return " ".repeat(width);
    }
    let half = (width - 1) / 2;
    format!("{:<half$}0{:>half$}", "-360", "360")
}

/// Returns a bar for a position between a full turn one way and a full turn the other way.
fn bar(position: Option<f64>, width: usize) -> Vec<Span<'static>> {
    let (Some(position), 5..) = (position, width) else {
        return vec![Span::styled("·".repeat(width), style::faint())];
    };
    let centre = (width - 1) / 2;
    let at = cell_of(position, width);
    let (from, to) = (centre.min(at), centre.max(at));
    let look = if position.abs() > TURN { style::bad() } else { style::good() };
    let text = |cells: std::ops::Range<usize>, filled: &str| -> String {
        let glyph = |cell| match cell {
            _ if cell == at => "█",
            _ if cell == centre => "┼",
            _ => filled,
        };
        cells.map(glyph).collect()
    };
    vec![
        Span::styled(text(0..from, "─"), style::faint()),
        Span::styled(text(from..to + 1, "━"), look),
        Span::styled(text(to + 1..width, "─"), style::faint()),
    ]
}

fn cell_of(position: f64, width: usize) -> usize {
    #[expect(clippy::cast_precision_loss, reason = "screens are not that wide")]
    let cell = (position.clamp(-TURN, TURN) + TURN) / (2.0 * TURN) * (width - 1) as f64;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and the width")]
    let cell = cell.round() as usize;
    cell.min(width - 1)
}

/// Returns the pose of the tool centre point and its speed, a line each.
pub(super) fn tcp_lines(status: &RobotStatus) -> Vec<Line<'static>> {
    let rows = POSE
        .into_iter()
        .enumerate()
        .map(|(index, name)| tcp_line(name, pose(status, index), if index < 3 { "mm" } else { "°" }));
    rows.chain([tcp_line("speed", status.tcp_speed, "mm/s")]).collect()
}

/// Returns the pose, three numbers a line.
pub(super) fn short_tcp_lines(status: &RobotStatus) -> Vec<Line<'static>> {
    short("", POSE, |index| pose(status, index))
}

fn pose(status: &RobotStatus, index: usize) -> Option<f64> {
    status.actual_position.map(|pose| <[f64; 6]>::from(pose)[index])
}

fn tcp_line(name: &'static str, value: Option<f64>, unit: &'static str) -> Line<'static> {
    let name = Span::styled(format!(" {name:<5}"), style::faint());
    Line::from(vec![name, number(value, 11, 3), Span::styled(format!(" {unit}"), style::faint())])
}

/// Returns two lines of three numbers.
fn short(prefix: &str, names: [&str; 6], value: impl Fn(usize) -> Option<f64>) -> Vec<Line<'static>> {
    let cell = |index: usize| {
        [Span::styled(format!(" {prefix}{:<2}", names[index]), style::faint()), number(value(index), 9, 2)]
    };
    [0..3, 3..6].map(|row| Line::from(row.flat_map(cell).collect::<Vec<_>>())).to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_shows_both_ways_and_never_leaves_its_width() {
        let text = |position| bar(Some(position), 11).iter().map(|span| &*span.content).collect::<String>();
        assert_eq!(text(0.0), "─────█─────");
        assert_eq!(text(360.0), "─────┼━━━━█");
        assert_eq!(text(-144.0), "───█━┼─────");
        assert_eq!(text(1e9), text(360.0));
        for width in 0..40 {
            assert_eq!(bar_heading(width | 1).chars().count(), width | 1);
            for position in [None, Some(-400.0), Some(-1.0), Some(0.0), Some(359.9)] {
                let cells: usize = bar(position, width).iter().map(|span| span.content.chars().count()).sum();
                assert_eq!(cells, width);
            }
        }
    }
}
