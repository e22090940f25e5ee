//! Styles of values.

use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};

use crate::packets::flags::Tone;
use crate::terminal::output::ABSENT;
use crate::text::number::fixed;

/// Style of names of values, rules and other details.
pub(super) fn faint() -> Style {
    Style::new().fg(Color::DarkGray)
}

/// Style of emphasized text.
pub(super) fn strong() -> Style {
    Style::new().add_modifier(Modifier::BOLD)
}

/// Style of a correct value.
pub(super) fn good() -> Style {
    Style::new().fg(Color::Green)
}

/// Style of a value that needs attention.
pub(super) fn notable() -> Style {
    Style::new().fg(Color::Yellow)
}

/// Style of a value that must not be overlooked, also without colours.
pub(super) fn bad() -> Style {
    Style::new().fg(Color::Red).add_modifier(Modifier::BOLD | Modifier::REVERSED)
}

/// Style of a value that is out of date.
pub(super) fn old() -> Style {
    faint().add_modifier(Modifier::DIM).remove_modifier(Modifier::BOLD)
}

/// Style of an alarm.
pub(super) fn of_tone(tone: Tone) -> Style {
    match tone {
        Tone::Bad => Style::new().fg(Color::Red).add_modifier(Modifier::BOLD),
        Tone::Warning => notable(),
        Tone::Good => good(),
        Tone::Plain => Style::new(),
    }
}

/// Returns a number at the right of its column.
pub(super) fn number(value: Option<f64>, width: usize, decimals: usize) -> Span<'static> {
    match value {
        Some(value) => Span::raw(format!("{:>width$}", fixed(value, decimals))),
        None => Span::styled(format!("{ABSENT:>width$}"), faint()),
    }
}

/// Returns a rule with a title.
pub(super) fn rule(title: &str, width: u16) -> Line<'static> {
    let rest = usize::from(width).saturating_sub(title.chars().count() + 4);
    Line::from(vec![
        Span::styled("─ ", faint()),
        Span::styled(title.to_owned(), strong()),
        Span::styled(format!(" {}", "─".repeat(rest + 1)), faint()),
    ])
}
