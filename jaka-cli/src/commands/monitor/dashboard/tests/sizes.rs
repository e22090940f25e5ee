//! Contents of windows of various sizes.

use expect_test::expect_file;
use jaka_sync::status::RobotStatus;

use super::{after_collision, at_work, check, screen, view};
use crate::commands::monitor::dashboard::view::Page;

#[test]
fn a_large_window_shows_more() {
    check(&at_work(), (120, 40), &expect_file!["screens/large_120x40.txt"]);
}

#[test]
fn a_small_window_shows_what_matters_most() {
    check(&at_work(), (40, 10), &expect_file!["screens/small_40x10.txt"]);
}

#[test]
fn no_size_is_too_small() {
    for mut view in [at_work(), after_collision(), view(RobotStatus::default())] {
        for page in Page::ALL {
            view.page = page;
            for (width, height) in [0, 1, 5, 19, 20, 39, 40, 60, 77, 79, 80, 81, 200].into_iter().flat_map(heights) {
                view.scroll = if height % 2 == 0 { u16::MAX } else { 1 };
                view.help = height % 3 == 0;
                screen(&view, width, height);
            }
        }
    }
}

fn heights(width: u16) -> impl Iterator<Item = (u16, u16)> {
    [0, 1, 2, 3, 7, 11, 12, 13, 23, 24, 25, 60].into_iter().map(move |height| (width, height))
}
