//! Display of present and missing values.

use std::time::Duration;

use expect_test::expect_file;
use jaka_sim::Firmware;
use jaka_sync::status::RobotStatus;
use ratatui::buffer::Buffer;
use ratatui::style::Color;

use super::{after_collision, at_work, check, packet, rows, screen, view};
use crate::commands::monitor::dashboard::View;
use crate::commands::monitor::dashboard::view::{Link, Page};

/// Text with control characters for a terminal, followed by a forged line.
const HOSTILE: &str = "A\u{1b}[2J\u{9b}\u{7f}\u{61c}\u{200e}\u{202e}\u{2066}\u{2028}\u{feff}\r\nB\tC";

#[test]
fn no_text_of_a_controller_reaches_the_screen_raw() {
    let mut view = view(packet(Firmware::Document, |state| {
        (state.powered, state.enabled) = (true, true);
        HOSTILE.clone_into(&mut state.error_code);
        HOSTILE.clone_into(&mut state.error_message);
    }));
    view.title = View::new(HOSTILE).title;
    for page in Page::ALL {
        view.page = page;
        for (width, height) in [(80, 24), (200, 60), (30, 10)] {
            let rows = rows(&screen(&view, width, height));
            let text = rows.concat();
            assert!(text.chars().all(jaka_sync::proto::text::is_visible), "{text:?}");
            if width == 200 {
                assert!(text.contains(r"A\u{1b}[2J\u{9b}\u{7f}"), "{text}");
            }
        }
    }
}

#[test]
fn stops_and_errors_stand_out() {
    check(&after_collision(), (80, 24), &expect_file!["screens/after_collision_80x24.txt"]);
}

#[test]
fn information_and_warnings_do_not_look_like_errors() {
    let row = |code: &str| {
        let mut view = at_work();
        view.status.as_mut().unwrap().error_code = Some(code.to_owned());
        let screen = screen(&view, 80, 24);
        let row = rows(&screen).into_iter().find(|row| row.contains("Event")).unwrap();
        (row.trim_end().to_owned(), colour(&screen, code))
    };
    assert_eq!(row("0x10f0015"), (" Event           information 0x10f0015 servo mode is on".to_owned(), Color::Reset));
    assert_eq!(row("0x10f0020"), (" Event           warning 0x10f0020 reduced mode is on".to_owned(), Color::Yellow));
    assert_eq!(row("0x0f0034"), (" Event            error 0x0f0034 a collision was detected".to_owned(), Color::Red));
    assert_eq!(row("0x0f9999"), (" Event            unknown 0x0f9999".to_owned(), Color::Red));
    assert_eq!(row("odd"), (" Event            unknown odd".to_owned(), Color::Red));
}

#[test]
fn what_no_packet_says_is_not_a_zero() {
    let mut view = view(RobotStatus::default());
    view.age = None;
    view.link = Link::default();
    check(&view, (80, 24), &expect_file!["screens/no_packet_80x24.txt"]);
}

#[test]
fn old_values_never_look_new() {
    let mut view = after_collision();
    let fresh = screen(&view, 80, 24);
    assert_eq!((colour(&fresh, "live"), colour(&fresh, "yes")), (Color::Green, Color::Green));
    for size in [(80, 24), (40, 12), (120, 40)] {
        view.age = Some(Duration::from_millis(501));
        let stale = screen(&view, size.0, size.1);
        assert_eq!((colour(&stale, "age"), colour(&stale, "yes")), (Color::Red, Color::DarkGray));
        assert!(rows(&stale)[0].contains("NO PACKETS"));
    }
    view.age = Some(Duration::from_millis(20));
    view.paused = true;
    let paused = screen(&view, 80, 24);
    assert_eq!(colour(&paused, "yes"), Color::DarkGray);
    assert!(rows(&paused)[0].contains("PAUSED"));
}

/// Returns the colour of the first cell of a text on the screen.
fn colour(buffer: &Buffer, wanted: &str) -> Color {
    let rows = rows(buffer);
    let (row, line) = rows.iter().enumerate().find(|(_, line)| line.contains(wanted)).expect(wanted);
    let column = line[..line.find(wanted).unwrap()].chars().count();
    buffer.content[row * usize::from(buffer.area.width) + column].fg
}
