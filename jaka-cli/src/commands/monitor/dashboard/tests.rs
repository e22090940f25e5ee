//! Contents of the screen, for packets of the simulated controller.

mod pages;
mod picture;
mod sizes;
mod values;

use std::time::{Duration, UNIX_EPOCH};

use expect_test::ExpectFile;
use jaka_sim::{Controller, Firmware, State};
use jaka_sync::StatusStream;
use jaka_sync::status::RobotStatus;
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;

use super::view::Link;
use super::{View, draw};

/// Returns a packet of a controller in this state.
fn packet(firmware: Firmware, change: impl FnOnce(&mut State)) -> RobotStatus {
    let builder = Controller::builder().stepped_clock().firmware(firmware).status_period(Duration::MAX);
    let controller = builder.start().unwrap();
    controller.set_state(change);
    StatusStream::connect(controller.status_addr()).unwrap().next_packet().unwrap()
}

/// Returns the view of an arm at work, 20 ms after the packet came.
fn view(status: RobotStatus) -> View {
    let link = Link {
        rate: Some(20.0),
        jitter: Some(Duration::from_micros(340)),
        longest_gap: Some(Duration::from_millis(61)),
        ..Link::default()
    };
    let age = Some(Duration::from_millis(20));
    let mut view = View { title: "cell1 (10.5.5.100)".to_owned(), status: None, age, link, ..View::default() };
    view.alarms.packet(&status, UNIX_EPOCH + Duration::from_secs(11 * 3600 + 55 * 60 + 7));
    view.status = Some(status);
    view
}

fn at_work() -> View {
    view(packet(Firmware::Document, |state| {
        (state.powered, state.enabled) = (true, true);
        state.joint_position = [-170.25, 90.0, 45.5, 90.0, -90.0, 355.0].into();
        state.digital_inputs[3] = true;
        state.digital_inputs[100] = true;
        state.tool_digital_inputs[0] = true;
    }))
}

fn after_collision() -> View {
    view(packet(Firmware::Document, |state| {
        (state.powered, state.enabled, state.protective_stop) = (true, true, true);
        "0x0f0034".clone_into(&mut state.error_code);
        "collision".clone_into(&mut state.error_message);
    }))
}

fn screen(view: &View, width: u16, height: u16) -> Buffer {
    let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
    terminal.draw(|frame| _ = draw(frame, view)).unwrap();
    terminal.backend().buffer().clone()
}

fn rows(buffer: &Buffer) -> Vec<String> {
    let rows = buffer.content.chunks(usize::from(buffer.area.width));
    rows.map(|row| row.iter().map(ratatui::buffer::Cell::symbol).collect()).collect()
}

fn check(view: &View, (width, height): (u16, u16), expected: &ExpectFile) {
    let rows = rows(&screen(view, width, height));
    let text: Vec<_> = rows.iter().map(|row| format!("{}\n", row.trim_end())).collect();
    expected.assert_eq(&text.concat());
}
