//! Inputs and outputs.

use jaka_sync::proto::wire::Typed;
use jaka_sync::status::RobotStatus;
use ratatui::text::{Line, Span};

use super::style;
use crate::terminal::output::ABSENT;
use crate::text::number::fixed;

/// Number of pins in a group.
const GROUP: usize = 8;
/// Width of the names of rows.
const NAME: usize = 10;
/// Width of the count of pins that are on, with a mark for pins not shown: `… 144/144 on`.
const COUNT: usize = 13;

/// Returns the lines of the cabinet and the tool, with at most `rows` lines of each kind.
pub(super) fn short_lines(status: &RobotStatus, width: u16, rows: usize) -> Vec<Line<'static>> {
    let mut lines = digital("in", status.digital_inputs.as_deref(), width, rows);
    lines.extend(digital("out", status.digital_outputs.as_deref(), width, rows));
    lines.push(tool(status));
    lines
}

/// Returns the lines of all inputs and outputs.
pub(super) fn lines(status: &RobotStatus, width: u16) -> Vec<Line<'static>> {
    let mut lines = vec![style::rule("Inputs and outputs: cabinet", width)];
    lines.extend(digital("in", status.digital_inputs.as_deref(), width, usize::MAX));
    lines.extend(digital("out", status.digital_outputs.as_deref(), width, usize::MAX));
    lines.extend(analog("analog in", status.analog_inputs.as_deref(), width));
    lines.extend(analog("analog out", status.analog_outputs.as_deref(), width));
    lines.extend(digital("relays", known(status.relay_outputs.as_ref()), width, usize::MAX));
    lines.push(style::rule("Inputs and outputs: tool", width));
    lines.extend(digital("in", status.tool_digital_inputs.as_deref(), width, usize::MAX));
    lines.extend(digital("out", status.tool_digital_outputs.as_deref(), width, usize::MAX));
    lines.extend(analog("analog in", status.tool_analog_inputs.as_deref(), width));
    for (title, [inputs, outputs], [analog_inputs, analog_outputs]) in fieldbuses(status) {
        if inputs.is_none() && outputs.is_none() && analog_inputs.is_none() && analog_outputs.is_none() {
            continue;
        }
        lines.push(style::rule(title, width));
        lines.extend(digital("in", inputs, width, usize::MAX));
        lines.extend(digital("out", outputs, width, usize::MAX));
        lines.extend(analog("analog in", analog_inputs, width));
        lines.extend(analog("analog out", analog_outputs, width));
    }
    lines
}

type Fieldbus<'s> = (&'static str, [Option<&'s [bool]>; 2], [Option<&'s [f64]>; 2]);

/// Returns the fieldbuses of newer firmware.
fn fieldbuses(status: &RobotStatus) -> [Fieldbus<'_>; 3] {
    [
        (
            "Modbus slave",
            [&status.modbus_slave_digital_inputs, &status.modbus_slave_digital_outputs]
                .map(|pins| known(pins.as_ref())),
            [&status.modbus_slave_analog_inputs, &status.modbus_slave_analog_outputs].map(|pins| known(pins.as_ref())),
        ),
        (
            "Profinet",
            [&status.profinet_device_digital_inputs, &status.profinet_device_digital_outputs]
                .map(|pins| known(pins.as_ref())),
            [&status.profinet_device_analog_inputs, &status.profinet_device_analog_outputs]
                .map(|pins| known(pins.as_ref())),
        ),
        (
            "EtherNet/IP",
            [&status.ethernet_ip_adapter_digital_inputs, &status.ethernet_ip_adapter_digital_outputs]
                .map(|pins| known(pins.as_ref())),
            [&status.ethernet_ip_adapter_analog_inputs, &status.ethernet_ip_adapter_analog_outputs]
                .map(|pins| known(pins.as_ref())),
        ),
    ]
}

fn known<T>(value: Option<&Typed<Vec<T>>>) -> Option<&[T]> {
    value.and_then(Typed::known).map(Vec::as_slice)
}

/// Returns the number of pins that fit on a line.
fn pins_per_line(width: u16) -> usize {
    usize::from(width).saturating_sub(NAME + COUNT + 2) / (GROUP + 1) * GROUP
}

/// Returns pins as dots, with the count of those that are on at the end of the first line.
fn digital(name: &str, pins: Option<&[bool]>, width: u16, rows: usize) -> Vec<Line<'static>> {
    let Some(pins) = pins else { return vec![absent(name)] };
    let per_line = pins_per_line(width).max(GROUP);
    let mut lines = Vec::new();
    for (row, part) in pins.chunks(per_line).take(rows).enumerate() {
        let label = if row == 0 { name.to_owned() } else { format!("{:>4}", row * per_line) };
        let mut spans = vec![label_span(&label)];
        spans.extend(dots(part));
        if row == 0 {
            spans.push(count(pins, rows.saturating_mul(per_line)));
        }
        lines.push(Line::from(spans));
    }
    if lines.is_empty() {
        vec![Line::from(vec![label_span(name), Span::styled("none", style::faint())])]
    } else {
        lines
    }
}

fn dots(pins: &[bool]) -> Vec<Span<'static>> {
    let mut spans = Vec::new();
    for group in pins.chunks(GROUP) {
        // One span for adjacent pins of the same state.
        for run in group.chunk_by(|one, other| one == other) {
            let (dot, look) = if run[0] { ("●", style::good()) } else { ("·", style::faint()) };
            spans.push(Span::styled(dot.repeat(run.len()), look));
        }
        spans.push(Span::raw(" "));
    }
    spans
}

/// Returns the count of the pins that are on. `…` marks pins not shown; the count is highlighted if one of these is on.
fn count(pins: &[bool], shown: usize) -> Span<'static> {
    let on = |pins: &[bool]| pins.iter().filter(|pin| **pin).count();
    let hidden = pins.get(shown..).unwrap_or_default();
    let look = if on(hidden) > 0 { style::notable() } else { style::faint() };
    let more = if hidden.is_empty() { "" } else { "… " };
    Span::styled(format!("{more}{}/{} on", on(pins), pins.len()), look)
}

fn tool(status: &RobotStatus) -> Line<'static> {
    let mut spans = vec![label_span("tool in")];
    spans.extend(dots_or_absent(status.tool_digital_inputs.as_deref()));
    spans.push(Span::styled("  out ", style::faint()));
    spans.extend(dots_or_absent(status.tool_digital_outputs.as_deref()));
    Line::from(spans)
}

fn dots_or_absent(pins: Option<&[bool]>) -> Vec<Span<'static>> {
    pins.map_or_else(|| vec![Span::styled(ABSENT, style::faint())], dots)
}

/// Returns the values other than 0, with their index.
fn analog(name: &str, values: Option<&[f64]>, width: u16) -> Vec<Line<'static>> {
    let Some(values) = values else { return vec![absent(name)] };
    let texts = values.iter().enumerate().filter(|(_, value)| **value != 0.0);
    let texts: Vec<_> = texts.map(|(index, value)| format!("[{index}] {:<10}", fixed(*value, 3))).collect();
    let which = match texts.len() {
        0 => ", all 0",
        count if count == values.len() => "",
        _ => ", all others 0",
    };
    let summary = format!("{} values{which}", values.len());
    let mut lines = vec![Line::from(vec![label_span(name), Span::styled(summary, style::faint())])];
    let per_line = (usize::from(width).saturating_sub(NAME + 2) / 16).max(1);
    lines.extend(texts.chunks(per_line).map(|row| Line::from(vec![label_span(""), Span::raw(row.concat())])));
    lines
}

fn absent(name: &str) -> Line<'static> {
    Line::from(vec![label_span(name), Span::styled(ABSENT, style::faint())])
}

fn label_span(name: &str) -> Span<'static> {
    Span::styled(format!(" {name:<NAME$} "), style::faint())
}
