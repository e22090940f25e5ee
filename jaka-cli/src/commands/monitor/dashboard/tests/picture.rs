//! Moving picture of the dashboard, `docs/monitor.svg`: an arm gets power, is enabled, moves, and meets an obstacle.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::time::{Duration, UNIX_EPOCH};

use expect_test::expect_file;
use jaka_robot::motion::JointMove;
use jaka_sim::{Controller, Firmware};
use jaka_sync::{Client, StatusStream};
use ratatui::buffer::{Buffer, Cell};
use ratatui::style::{Color, Modifier};

use super::super::view::{Link, Page, View};
use super::screen;

const SIZE: (u16, u16) = (80, 24);
/// Width of a column and height of a row, in pixels.
const CELL: (f64, f64) = (8.4, 18.0);
const MARGIN: f64 = 10.0;
const BACKGROUND: &str = "#11151c";
const FOREGROUND: &str = "#d8dee9";

/// A screen, and the time for which it is shown.
struct Frame {
    screen: Buffer,
    shown: Duration,
}

/// The arm of the picture, its client, and the dashboard.
struct Story {
    controller: Controller,
    view: View,
    frames: Vec<Frame>,
}

impl Story {
    fn new() -> Self {
        let builder = Controller::builder().stepped_clock().firmware(Firmware::Newer).status_period(Duration::MAX);
        let controller = builder.start().unwrap();
        let link = Link {
            rate: Some(20.0),
            jitter: Some(Duration::from_micros(340)),
            longest_gap: Some(Duration::from_millis(61)),
            ..Link::default()
        };
        let view = View { link, age: Some(Duration::from_millis(20)), ..View::new("cell1 (10.5.5.100)") };
        Self { controller, view, frames: Vec::new() }
    }

    /// Shows the arm as it is after this time, for as long.
    fn frame(&mut self, shown: Duration) {
        self.controller.advance(shown);
        let packet = StatusStream::connect(self.controller.status_addr()).unwrap().next_packet().unwrap();
        let clock = UNIX_EPOCH + Duration::from_secs(11 * 3600 + 55 * 60) + self.controller.elapsed();
        self.view.alarms.packet(&packet, clock);
        self.view.status = Some(packet);
        self.frames.push(Frame { screen: screen(&self.view, SIZE.0, SIZE.1), shown });
    }

    fn frames(&mut self, count: usize, shown: Duration) {
        for _ in 0..count {
            self.frame(shown);
        }
    }
}

fn story() -> Vec<Frame> {
    let step = Duration::from_millis(250);
    let mut story = Story::new();
    let mut client = Client::connect(story.controller.command_addr()).unwrap();
    story.frame(step * 4);
    client.power_on().unwrap();
    story.controller.advance(Duration::from_secs(10));
    story.frame(step * 4);
    client.enable_robot().unwrap();
    story.controller.advance(Duration::from_secs(5));
    story.frame(step * 4);
    client.joint_move(&JointMove::relative([70.0, -25.0, 40.0, 15.0, -30.0, 90.0], 18.0)).unwrap();
    story.frames(16, step);
    story.controller.collide();
    story.frames(2, step);
    story.frame(step * 8);
    story.view.page = Page::Alarms;
    story.frame(step * 10);
    story.frames
}

#[test]
fn the_moving_picture_is_that_of_the_dashboard() {
    let frames = story();
    let texts: Vec<String> = frames.iter().map(|frame| super::rows(&frame.screen).concat()).collect();
    assert!(texts.windows(2).filter(|pair| pair[0] != pair[1]).count() > 12, "the picture moves");
    expect_file!["../../../../../../docs/monitor.svg"].assert_eq(&svg(&frames));
}

/// An SVG in which each element is shown in the frames that have it: a group for each range of frames.
fn svg(frames: &[Frame]) -> String {
    let mut ends = vec![Duration::ZERO];
    ends.extend(frames.iter().scan(Duration::ZERO, |end, frame| {
        *end += frame.shown;
        Some(*end)
    }));
    let period_s = ends[frames.len()].as_secs_f64();
    let (width, height) = (f64::from(SIZE.0) * CELL.0 + 2.0 * MARGIN, f64::from(SIZE.1) * CELL.1 + 2.0 * MARGIN);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {width:.0} {height:.0}\" role=\"img\">\n\
         <title>jaka monitor: an arm gets power, is enabled, moves, and stops at an obstacle</title>\n\
         <style>text{{font:14px ui-monospace,Menlo,Consolas,'DejaVu Sans Mono',monospace;fill:{FOREGROUND};\
         white-space:pre}}.b{{font-weight:bold}}\
         .f{{visibility:hidden;animation:{period_s:.2}s step-end infinite}}\n"
    );
    let groups = groups(frames);
    for (index, range) in groups.keys().enumerate() {
        let percent = |frame: usize| ends[frame].as_secs_f64() / period_s * 100.0;
        write!(text, "#g{index}{{animation-name:g{index}}}@keyframes g{index}{{0%{{visibility:hidden}}").unwrap();
        write!(text, "{:.2}%{{visibility:visible}}", percent(range.start)).unwrap();
        writeln!(
            text,
            "{:.2}%{{visibility:{}}}}}",
            percent(range.end),
            ["hidden", "visible"][usize::from(range.end == frames.len())]
        )
        .unwrap();
    }
    text.push_str("</style>\n");
    writeln!(text, "<rect width=\"100%\" height=\"100%\" rx=\"8\" fill=\"{BACKGROUND}\"/>").unwrap();
    for (index, elements) in groups.values().enumerate() {
        writeln!(text, "<g class=\"f\" id=\"g{index}\">\n{}</g>", elements.concat()).unwrap();
    }
    text + "</svg>\n"
}

/// The elements of all screens by the frames, from the first to the last, in which they stand without a break.
fn groups(frames: &[Frame]) -> BTreeMap<Span, Vec<String>> {
    let mut groups: BTreeMap<Span, Vec<String>> = BTreeMap::new();
    let mut shown: BTreeMap<String, usize> = BTreeMap::new();
    for (frame, screen) in frames.iter().map(|frame| Some(&frame.screen)).chain([None]).enumerate() {
        let elements: BTreeSet<String> = screen.map(runs).into_iter().flatten().collect();
        let (still, ended): (BTreeMap<_, _>, BTreeMap<_, _>) =
            shown.into_iter().partition(|(element, _)| elements.contains(element));
        shown = still;
        for (element, start) in ended {
            groups.entry(Span { start, end: frame }).or_default().push(element);
        }
        for element in elements {
            shown.entry(element).or_insert(frame);
        }
    }
    groups
}

/// Frames from one to the one before another.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Span {
    start: usize,
    end: usize,
}

/// The elements of a screen: adjacent cells of one style are one text.
fn runs(screen: &Buffer) -> Vec<String> {
    let mut elements = Vec::new();
    for (row, cells) in screen.content.chunks(usize::from(SIZE.0)).enumerate() {
        let mut column = 0;
        for run in cells.chunk_by(|one, next| style(one) == style(next)) {
            element(&mut elements, row, column, run);
            column += run.len();
        }
    }
    elements
}

fn style(cell: &Cell) -> (Color, Color, Modifier) {
    (cell.fg, cell.bg, cell.modifier)
}

fn element(elements: &mut Vec<String>, row: usize, column: usize, run: &[Cell]) {
    let (fg, bg, modifier) = style(&run[0]);
    let (mut ink, mut paper) = (color(fg).unwrap_or(FOREGROUND), color(bg));
    if modifier.contains(Modifier::REVERSED) {
        (ink, paper) = (paper.unwrap_or(BACKGROUND), Some(ink));
    }
    let text: String = run.iter().map(Cell::symbol).collect();
    #[expect(clippy::cast_precision_loss, reason = "a screen has few cells")]
    let (row, column, columns) = (row as f64, column as f64, run.len() as f64);
    let (x, y) = (MARGIN + column * CELL.0, MARGIN + row * CELL.1);
    if let Some(paper) = paper {
        let (width, height) = (columns * CELL.0, CELL.1);
        elements.push(format!(
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"{paper}\"/>\n"
        ));
    }
    if text.trim().is_empty() {
        return;
    }
    let bold = if modifier.contains(Modifier::BOLD) { " class=\"b\"" } else { "" };
    let fill = if ink == FOREGROUND { String::new() } else { format!(" style=\"fill:{ink}\"") };
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    let (baseline, length) = (y + 13.5, columns * CELL.0);
    elements.push(format!(
        "<text x=\"{x:.1}\" y=\"{baseline:.1}\" textLength=\"{length:.1}\" xml:space=\"preserve\"{bold}{fill}>{text}</text>\n"
    ));
}

/// The colour of a terminal in the picture, `None` for its own.
fn color(color: Color) -> Option<&'static str> {
    match color {
        Color::Reset => None,
        Color::Red => Some("#f2777a"),
        Color::Green => Some("#99cc66"),
        Color::Yellow => Some("#ffcc66"),
        Color::Cyan => Some("#66cccc"),
        Color::DarkGray => Some("#7a8494"),
        other => panic!("the picture has no {other}"),
    }
}
