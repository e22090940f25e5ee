//! State of the robot: power, stops, modes, event.

use jaka_sync::Severity;
use jaka_sync::proto::text::visible;
use jaka_sync::status::{InterpreterState, RobotStatus};
use ratatui::style::Style;
use ratatui::text::{Line, Span};

use super::style;
use crate::packets::event;
use crate::terminal::output::ABSENT;

/// Value with a long and a short name, and its style.
#[derive(Clone)]
struct Cell {
    names: [&'static str; 2],
    value: Option<(String, Style)>,
}

/// Layout of the cells.
struct Grid {
    columns: usize,
    cell: usize,
    name: usize,
    /// Index of the shown name in a cell's two names.
    which: usize,
}

impl Grid {
    /// Returns the layout for a window of this width.
    fn of(width: usize) -> Self {
        match width {
            78.. => Self { columns: 3, cell: (width / 3).min(32), name: 16, which: 0 },
            40.. => Self { columns: 2, cell: 20, name: 12, which: 1 },
            _ => Self { columns: 1, cell: width, name: 12, which: 1 },
        }
    }
}

/// Returns the state as lines that fit the width.
pub(super) fn lines(status: &RobotStatus, width: u16) -> Vec<Line<'static>> {
    let grid = Grid::of(usize::from(width));
    let mut cells = cells(status).to_vec();
    let event = event_cell(status);
    // An event has its own line; with few lines, a missing event has none.
    let is_short = status.error_code.is_some() && matches!(status.event(), Ok(None));
    if grid.columns == 2 && is_short {
        cells.push(event);
        return cells.chunks(grid.columns).map(|row| line(row, &grid)).collect();
    }
    let rows = cells.chunks(grid.columns).chain([std::slice::from_ref(&event)]);
    rows.map(|row| line(row, &grid)).collect()
}

fn line(cells: &[Cell], grid: &Grid) -> Line<'static> {
    let mut spans = Vec::new();
    for cell in cells {
        let (value, look) = cell.value.clone().unwrap_or_else(|| (ABSENT.to_owned(), style::faint()));
        let left = grid.cell.saturating_sub(grid.name + 1 + value.chars().count());
        spans.push(Span::styled(format!(" {:<1$}", cell.names[grid.which], grid.name), style::faint()));
        spans.extend([Span::styled(value, look), Span::raw(" ".repeat(left))]);
    }
    Line::from(spans)
}

fn cells(status: &RobotStatus) -> [Cell; 9] {
    let yes_no = ["no", "yes"];
    let alarm = [Style::new(), style::bad()];
    let wanted = [style::notable(), style::good()];
    [
        flag(["Power", "Power"], status.powered_on, ["off", "on"], wanted),
        flag(["Enabled", "Enabled"], status.enabled, yes_no, wanted),
        flag(["In position", "In position"], status.in_position, yes_no, [style::notable(), Style::new()]),
        flag(["Protective stop", "Prot. stop"], status.protective_stop, yes_no, alarm),
        flag(["Emergency stop", "Em. stop"], status.emergency_stop, yes_no, alarm),
        flag(["Drag mode", "Drag"], status.drag_status, ["off", "on"], [Style::new(), style::notable()]),
        Cell { names: ["Program", "Program"], value: status.interpreter_state.map(program) },
        Cell { names: ["Task mode", "Mode"], value: status.task_mode.map(|mode| (mode.to_string(), Style::new())) },
        Cell { names: ["Rapid rate", "Rapid rate"], value: status.rapid_rate.map(rate) },
    ]
}

fn flag(names: [&'static str; 2], value: Option<bool>, texts: [&str; 2], looks: [Style; 2]) -> Cell {
    let value = value.map(usize::from).map(|at| (texts[at].to_owned(), looks[at]));
    Cell { names, value }
}

fn program(state: InterpreterState) -> (String, Style) {
    let look = match state {
        InterpreterState::Loading | InterpreterState::Paused => style::notable(),
        InterpreterState::Running => style::good(),
        _ => Style::new(),
    };
    (state.to_string(), look)
}

fn rate(rate: f64) -> (String, Style) {
    let look = if rate < 1.0 { style::notable() } else { Style::new() };
    (format!("{} %", crate::text::number::fixed(rate * 100.0, 0)), look)
}

/// Returns the controller's event, if the packet has it, and its style: that of an alarm, unless it is known to be less
/// severe.
fn event_cell(status: &RobotStatus) -> Cell {
    let value = status.error_code.as_ref().map(|code| {
        let reading = status.event();
        let Some(severity) = event::severity(&reading) else { return ("none".to_owned(), Style::new()) };
        let message = status.error_message.as_deref().filter(|message| !message.is_empty());
        let message = message.or(event::meaning(&reading)).unwrap_or_default();
        let text = visible(&format!("{severity} {code} {message}")).into_owned();
        match severity {
            Severity::Information => (text, Style::new()),
            Severity::Warning => (text, style::notable()),
            _ => (format!(" {} ", text.trim_end()), style::bad()),
        }
    });
    Cell { names: ["Event", "Event"], value }
}
