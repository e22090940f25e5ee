//! Contents of each page.

use expect_test::expect_file;
use jaka_sim::Firmware;
use ratatui::Terminal;
use ratatui::backend::TestBackend;

use super::{after_collision, at_work, check, packet, rows, view};
use crate::commands::monitor::dashboard::draw;
use crate::commands::monitor::dashboard::view::Page;

#[test]
fn everything_fits_a_usual_terminal() {
    check(&at_work(), (80, 24), &expect_file!["screens/overview_80x24.txt"]);
}

#[test]
fn the_other_pages_show_all_there_is() {
    let mut view = at_work();
    view.page = Page::Io;
    check(&view, (80, 24), &expect_file!["screens/io_80x24.txt"]);
    view.page = Page::Measurements;
    check(&view, (80, 30), &expect_file!["screens/measurements_80x30.txt"]);
    let mut view = after_collision();
    view.page = Page::Alarms;
    check(&view, (80, 12), &expect_file!["screens/alarms_80x12.txt"]);
}

#[test]
fn newer_firmware_has_fieldbuses() {
    let mut view = view(packet(Firmware::Newer, |state| state.analog_inputs[5] = 2.5));
    view.page = Page::Io;
    check(&view, (100, 40), &expect_file!["screens/newer_io_100x40.txt"]);
}

#[test]
fn the_help_lies_over_the_page() {
    let mut view = at_work();
    view.help = true;
    check(&view, (80, 24), &expect_file!["screens/help_80x24.txt"]);
}

#[test]
fn the_last_line_of_a_page_stays_in_sight() {
    let mut view = at_work();
    (view.page, view.scroll) = (Page::Measurements, u16::MAX);
    let mut terminal = Terminal::new(TestBackend::new(80, 20)).unwrap();
    let mut most = 0;
    terminal.draw(|frame| most = draw(frame, &view)).unwrap();
    assert!(rows(terminal.backend().buffer())[18].contains("raw reading"));
    view.scroll_at_most(most);
    assert_eq!(view.scroll, most);
}
