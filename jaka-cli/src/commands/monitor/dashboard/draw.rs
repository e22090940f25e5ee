//! Screen: header, page, footer.

use std::time::Duration;

use ratatui::Frame;
use ratatui::layout::{Alignment, Constraint, Layout, Rect};
use ratatui::style::Style;
use ratatui::text::{Line, Span, Text};
use ratatui::widgets::{Block, Clear, Paragraph};

use super::keys::KEYS;
use super::view::{Link, Page, STALE};
use super::{View, alarms, io, measurements, overview, style};
use crate::packets::flags::Tone;
use crate::terminal::output::ABSENT;
use crate::text::number::fixed;

/// Smallest height of a window with a footer and a header of more than one line.
const LOW: u16 = 12;

/// Draws the screen, and returns the greatest scroll position of the page.
pub(crate) fn draw(frame: &mut Frame<'_>, view: &View) -> u16 {
    let (header, footer) = if frame.area().height < LOW { (1, 0) } else { (2, 1) };
    let heights = [Constraint::Length(header), Constraint::Min(0), Constraint::Length(footer)];
    let [top, page, bottom] = Layout::vertical(heights).areas(frame.area());
    frame.render_widget(Text::from(vec![title_line(view, top.width), link_line(&view.link)]), top);
    let most = draw_page(frame, page, view);
    frame.render_widget(footer_line(view, bottom.width), bottom);
    if view.help {
        draw_help(frame);
    }
    most
}

fn draw_page(frame: &mut Frame<'_>, area: Rect, view: &View) -> u16 {
    let unknown = jaka_sync::status::RobotStatus::default();
    let status = view.status.as_ref().unwrap_or(&unknown);
    let most = match view.page {
        Page::Overview if overview::fits(area) => {
            overview::draw(frame, area, view, status);
            return 0;
        }
        Page::Overview => return scrolled(frame, area, overview::lines(view, status, area.width), view.scroll),
        Page::Io => scrolled(frame, area, io::lines(status, area.width), view.scroll),
        Page::Measurements => {
            let lines = measurements::lines(status, &view.packed, area.width);
            scrolled(frame, area, lines, view.scroll)
        }
        Page::Alarms => {
            let title = style::rule("Alarms (UTC), the newest first", area.width);
            let lines = std::iter::once(title).chain(view.alarms.lines(area.width)).collect();
            return scrolled(frame, area, lines, view.scroll);
        }
    };
    if !view.is_fresh() {
        frame.buffer_mut().set_style(area, style::old());
    }
    most
}

/// Draws lines from the scroll position on, and returns the greatest position, at which the last line is visible.
fn scrolled(frame: &mut Frame<'_>, area: Rect, lines: Vec<Line<'static>>, scroll: u16) -> u16 {
    let most = lines.len().saturating_sub(usize::from(area.height));
    let most = u16::try_from(most).unwrap_or(u16::MAX);
    frame.render_widget(Paragraph::new(lines).scroll((scroll.min(most), 0)), area);
    most
}

/// Returns the title line: the robot, and whether its state is current.
fn title_line(view: &View, width: u16) -> Line<'static> {
    let (state, look) = freshness(view);
    let age = view.age.map_or_else(String::new, |age| format!(" age {} ", age_text(age)));
    let age_look = if view.age.is_some_and(|age| age > STALE) { style::bad() } else { Style::new() };
    let name = format!(" jaka monitor  {}", view.title);
    let used = name.chars().count() + state.chars().count() + age.chars().count();
    let gap = " ".repeat(usize::from(width).saturating_sub(used).max(1));
    // In a window too narrow for all, the state comes first.
    if used >= usize::from(width) {
        return Line::from(vec![Span::styled(state, look), Span::styled(age, age_look), Span::raw(view.title.clone())]);
    }
    Line::from(vec![
        Span::styled(name, style::strong()),
        Span::raw(gap),
        Span::styled(state, look),
        Span::styled(age, age_look),
    ])
}

fn freshness(view: &View) -> (String, Style) {
    match (&view.link.ended, view.age) {
        (Some(_), _) => (" DISCONNECTED ".to_owned(), style::bad()),
        (None, None) => (" NO PACKET YET ".to_owned(), style::bad()),
        (None, Some(_)) if view.paused => (" PAUSED ".to_owned(), style::notable().reversed()),
        (None, Some(age)) if age > STALE => (" NO PACKETS ".to_owned(), style::bad()),
        (None, Some(_)) => (" ● live ".to_owned(), style::good()),
    }
}

fn age_text(age: Duration) -> String {
    if age < Duration::from_secs(1) { format!("{} ms", age.as_millis()) } else { alarms::duration(age) }
}

/// Returns the line on the reception of packets.
fn link_line(link: &Link) -> Line<'static> {
    if let Some(cause) = &link.ended {
        return Line::styled(format!(" {cause}"), style::of_tone(Tone::Bad));
    }
    let ms = |time: Duration, decimals| format!("{} ms", fixed(time.as_secs_f64() * 1000.0, decimals));
    let rate = link.rate.map(|rate| format!("{}/s", fixed(rate, 1)));
    let jitter = link.jitter.map(|jitter| ms(jitter, 1));
    let gap = link.longest_gap.map(|gap| ms(gap, 0));
    let mut spans = Vec::new();
    for (name, value) in [("rate", rate), ("jitter", jitter), ("longest gap", gap)] {
        let value = value.unwrap_or_else(|| ABSENT.to_owned());
        spans.extend([Span::styled(format!(" {name} "), style::faint()), Span::raw(value)]);
    }
    for (name, count) in [("skipped", link.skipped), ("unfit", link.unfit), ("reconnects", link.reconnects)] {
        let look = if count > 0 { style::notable() } else { Style::new() };
        spans.extend([Span::styled(format!(" {name} "), style::faint()), Span::styled(count.to_string(), look)]);
    }
    Line::from(spans)
}

fn footer_line(view: &View, width: u16) -> Line<'static> {
    let keys = if width < 78 { " ? help" } else { " q quit  p pause  Tab page  ↑↓ scroll  ? help" };
    let mut spans = vec![Span::styled(keys, style::faint())];
    let names: usize = Page::ALL.iter().map(|page| page.name().chars().count() + 1).sum();
    let gap = usize::from(width).saturating_sub(keys.chars().count() + names);
    spans.push(Span::raw(" ".repeat(gap)));
    for page in Page::ALL {
        let look = if page == view.page { style::strong().reversed() } else { style::faint() };
        spans.extend([Span::styled(page.name(), look), Span::raw(" ")]);
    }
    Line::from(spans)
}

/// Draws the keys, and notes on values that are not shown.
fn draw_help(frame: &mut Frame<'_>) {
    let mut lines: Vec<_> = KEYS.iter().map(|(key, what)| Line::from(format!(" {key:<24} {what}"))).collect();
    lines.extend(
        [
            "",
            " Nothing is ever sent to the robot. Values that a",
            " packet does not have are shown as –. Status packets",
            " do not say whether servo mode is on.",
        ]
        .map(Line::from),
    );
    let area = centred(frame.area(), 54, u16::try_from(lines.len() + 2).unwrap_or(u16::MAX));
    frame.render_widget(Clear, area);
    let block = Block::bordered().title(" Keys ").title_alignment(Alignment::Center);
    frame.render_widget(Paragraph::new(lines).block(block), area);
}

fn centred(area: Rect, width: u16, height: u16) -> Rect {
    let (width, height) = (width.min(area.width), height.min(area.height));
    Rect { x: area.x + (area.width - width) / 2, y: area.y + (area.height - height) / 2, width, height }
}
