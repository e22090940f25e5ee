//! First page: the most important values, as far as the window has space for them.

use jaka_sync::status::RobotStatus;
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::text::{Line, Text};

use super::{View, io, joints, robot_state, style};
use crate::terminal::output::ABSENT;

/// Smallest size for all values, without the header and the footer.
const FULL: (u16, u16) = (80, 21);
/// Width of the pose column.
const TCP_WIDTH: u16 = 24;
/// Lines of the state and of the joints, with their rules.
const STATE: u16 = 5;
const JOINTS: u16 = 8;
/// Smallest number of lines for alarms, with their rule.
const ALARMS: u16 = 4;

/// Whether all values fit into an area.
pub(super) fn fits(area: Rect) -> bool {
    area.width >= FULL.0 && area.height >= FULL.1
}

/// Draws the page with all values.
pub(super) fn draw(frame: &mut Frame<'_>, area: Rect, view: &View, status: &RobotStatus) {
    let left = area.height - STATE - JOINTS - ALARMS;
    let pins = pins(status, area.width, usize::from(left));
    let pins_height = u16::try_from(pins.len()).unwrap_or(u16::MAX);
    let heights =
        [Constraint::Length(STATE), Constraint::Length(JOINTS), Constraint::Length(pins_height), Constraint::Min(0)];
    let [state, arm, io_area, alarms] = Layout::vertical(heights).areas(area);
    let [joints_area, tcp] = Layout::horizontal([Constraint::Min(0), Constraint::Length(TCP_WIDTH)]).areas(arm);
    part(frame, state, "State", robot_state::lines(status, state.width));
    part(frame, joints_area, "Joints", joints::lines(status, joints_area.width));
    part(frame, tcp, &tcp_title(status), joints::tcp_lines(status));
    frame.render_widget(Text::from(pins), io_area);
    part(frame, alarms, "Alarms (UTC)", view.alarms.lines(alarms.width));
    if !view.is_fresh() {
        for area in [state, arm, io_area] {
            frame.buffer_mut().set_style(area, style::old());
        }
    }
}

/// Returns all inputs and outputs, or as many of them as fit.
fn pins(status: &RobotStatus, width: u16, height: usize) -> Vec<Line<'static>> {
    let all = io::lines(status, width);
    if all.len() <= height {
        return all;
    }
    let rows = (height.saturating_sub(2) / 2).max(1);
    std::iter::once(style::rule("Digital I/O", width)).chain(io::short_lines(status, width, rows)).collect()
}

/// Returns all parts in one column, the most important first.
pub(super) fn lines(view: &View, status: &RobotStatus, width: u16) -> Vec<Line<'static>> {
    let mut values = robot_state::lines(status, width);
    values.extend(joints::short_lines(status));
    values.extend(joints::short_tcp_lines(status));
    values.extend(io::short_lines(status, width, 1));
    if !view.is_fresh() {
        values.iter_mut().flat_map(|line| &mut line.spans).for_each(|span| span.style = style::old());
    }
    values.push(style::rule("Alarms (UTC)", width));
    values.extend(view.alarms.lines(width));
    values
}

fn part(frame: &mut Frame<'_>, area: Rect, title: &str, lines: Vec<Line<'static>>) {
    let with_rule = std::iter::once(style::rule(title, area.width)).chain(lines);
    frame.render_widget(with_rule.collect::<Text<'_>>(), area);
}

fn tcp_title(status: &RobotStatus) -> String {
    let id = |id: Option<i64>| id.map_or_else(|| ABSENT.to_owned(), |id| id.to_string());
    format!("TCP tool {} user {}", id(status.current_tool_id), id(status.current_user_frame_id))
}
