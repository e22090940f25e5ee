//! What is on the screen, for packets of the simulated controller.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use std::time::{Duration, UNIX_EPOCH};

use expect_test::{Expect, expect};
use jaka_sim::{Controller, Firmware, State};
use jaka_sync::StatusStream;
use jaka_sync::status::RobotStatus;
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;
use ratatui::style::Color;

use super::view::{Link, Page};
use super::{View, draw};

/// A packet of a controller in this state.
fn packet(firmware: Firmware, change: impl FnOnce(&mut State)) -> RobotStatus {
    let builder = Controller::builder().stepped_clock().firmware(firmware).status_period(Duration::MAX);
    let controller = builder.start().unwrap();
    controller.set_state(change);
    StatusStream::connect(controller.status_addr()).unwrap().next_packet().unwrap()
}

/// An arm at work, as the view shows it 20 ms after the packet came.
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

/// A terminal would obey it, and it is followed by a forged line.
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

fn screen(view: &View, width: u16, height: u16) -> Buffer {
    let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
    terminal.draw(|frame| _ = draw(frame, view)).unwrap();
    terminal.backend().buffer().clone()
}

fn rows(buffer: &Buffer) -> Vec<String> {
    let rows = buffer.content.chunks(usize::from(buffer.area.width));
    rows.map(|row| row.iter().map(ratatui::buffer::Cell::symbol).collect()).collect()
}

fn check(view: &View, (width, height): (u16, u16), expected: &Expect) {
    // With a border, since expect-test removes the indentation that all lines share.
    let rows = rows(&screen(view, width, height));
    let text: Vec<_> = rows.iter().map(|row| format!("|{}\n", row.trim_end())).collect();
    expected.assert_eq(&text.concat());
}

#[test]
fn everything_fits_a_usual_terminal() {
    check(
        &at_work(),
        (80, 24),
        &expect![[r#"
            | jaka monitor  cell1 (10.5.5.100)                             ● live  age 20 ms
            | rate 20.0/s jitter 0.3 ms longest gap 61 ms skipped 0 unfit 0 reconnects 0
            |─ State ────────────────────────────────────────────────────────────────────────
            | Power           on        Enabled         yes       In position     yes
            | Protective stop no        Emergency stop  no        Drag mode       off
            | Program         idle      Task mode       manual    Rapid rate      100 %
            | Event           none
            |─ Joints ──────────────────────────────────────────────── TCP tool 0 user 0 ────
            |   position ° -360     0      360 current torque  temp   x        432.041 mm
            | 1   -170.250 ─────█━━━┼─────────    0.00   0.00   0.0   y        -41.433 mm
            | 2     90.000 ─────────┼━█───────    0.00   0.00   0.0   z        811.670 mm
            | 3     45.500 ─────────┼█────────    0.00   0.00   0.0   rx      -135.609 °
            | 4     90.000 ─────────┼━█───────    0.00   0.00   0.0   ry        -3.502 °
            | 5    -90.000 ───────█━┼─────────    0.00   0.00   0.0   rz       -76.679 °
            | 6    355.000 ─────────┼━━━━━━━━█    0.00   0.00   0.0   speed      0.000 mm/s
            |─ Digital I/O ──────────────────────────────────────────────────────────────────
            | in         ···●···· ········ ········ ········ ········ ········ … 2/144 on
            | out        ········ ········ ········ ········ ········ ········ … 0/144 on
            | tool in    ●·······   out ········
            |─ Alarms (UTC) ─────────────────────────────────────────────────────────────────
            | none since the start
            |
            |
            | q quit  p pause  Tab page  ↑↓ scroll  ? help  Overview I/O Measurements Alarms
        "#]],
    );
}

#[test]
fn a_large_window_shows_more() {
    check(
        &at_work(),
        (120, 40),
        &expect![[r#"
            | jaka monitor  cell1 (10.5.5.100)                                                                     ● live  age 20 ms
            | rate 20.0/s jitter 0.3 ms longest gap 61 ms skipped 0 unfit 0 reconnects 0
            |─ State ────────────────────────────────────────────────────────────────────────────────────────────────────────────────
            | Power           on              Enabled         yes             In position     yes
            | Protective stop no              Emergency stop  no              Drag mode       off
            | Program         idle            Task mode       manual          Rapid rate      100 %
            | Event           none
            |─ Joints ──────────────────────────────────────────────────────────────────────────────────────── TCP tool 0 user 0 ────
            |   position ° -360                 0                  360 current torque  temp voltage   power   x        432.041 mm
            | 1   -170.250 ───────────█━━━━━━━━━┼─────────────────────    0.00   0.00   0.0     0.0     0.0   y        -41.433 mm
            | 2     90.000 ─────────────────────┼━━━━█────────────────    0.00   0.00   0.0     0.0     0.0   z        811.670 mm
            | 3     45.500 ─────────────────────┼━━█──────────────────    0.00   0.00   0.0     0.0     0.0   rx      -135.609 °
            | 4     90.000 ─────────────────────┼━━━━█────────────────    0.00   0.00   0.0     0.0     0.0   ry        -3.502 °
            | 5    -90.000 ────────────────█━━━━┼─────────────────────    0.00   0.00   0.0     0.0     0.0   rz       -76.679 °
            | 6    355.000 ─────────────────────┼━━━━━━━━━━━━━━━━━━━━█    0.00   0.00   0.0     0.0     0.0   speed      0.000 mm/s
            |─ Inputs and outputs: cabinet ──────────────────────────────────────────────────────────────────────────────────────────
            | in         ···●···· ········ ········ ········ ········ ········ ········ ········ ········ ········ 2/144 on
            |   80       ········ ········ ····●··· ········ ········ ········ ········ ········
            | out        ········ ········ ········ ········ ········ ········ ········ ········ ········ ········ 0/144 on
            |   80       ········ ········ ········ ········ ········ ········ ········ ········
            | analog in  66 values, all 0
            | analog out 66 values, all 0
            | relays     –
            |─ Inputs and outputs: tool ─────────────────────────────────────────────────────────────────────────────────────────────
            | in         ●······· 1/8 on
            | out        ········ 0/8 on
            | analog in  1 values, all 0
            |─ Alarms (UTC) ─────────────────────────────────────────────────────────────────────────────────────────────────────────
            | none since the start
            |
            |
            |
            |
            |
            |
            |
            |
            |
            |
            | q quit  p pause  Tab page  ↑↓ scroll  ? help                                          Overview I/O Measurements Alarms
        "#]],
    );
}

#[test]
fn a_small_window_shows_what_matters_most() {
    check(
        &at_work(),
        (40, 10),
        &expect![[r#"
            | ● live  age 20 ms cell1 (10.5.5.100)
            | Power       on      Enabled     yes
            | In position yes     Prot. stop  no
            | Em. stop    no      Drag        off
            | Program     idle    Mode        manual
            | Rapid rate  100 %   Event       none
            | J1   -170.25 J2     90.00 J3     45.50
            | J4     90.00 J5    -90.00 J6    355.00
            | x    432.04 y    -41.43 z    811.67
            | rx  -135.61 ry    -3.50 rz   -76.68
        "#]],
    );
}

#[test]
fn stops_and_errors_stand_out() {
    check(
        &after_collision(),
        (80, 24),
        &expect![[r#"
            | jaka monitor  cell1 (10.5.5.100)                             ● live  age 20 ms
            | rate 20.0/s jitter 0.3 ms longest gap 61 ms skipped 0 unfit 0 reconnects 0
            |─ State ────────────────────────────────────────────────────────────────────────
            | Power           on        Enabled         yes       In position     yes
            | Protective stop yes       Emergency stop  no        Drag mode       off
            | Program         idle      Task mode       manual    Rapid rate      100 %
            | Event            error 0x0f0034 collision
            |─ Joints ──────────────────────────────────────────────── TCP tool 0 user 0 ────
            |   position ° -360     0      360 current torque  temp   x       -482.000 mm
            | 1      0.000 ─────────█─────────    0.00   0.00   0.0   y        114.000 mm
            | 2     90.000 ─────────┼━█───────    0.00   0.00   0.0   z        443.150 mm
            | 3     90.000 ─────────┼━█───────    0.00   0.00   0.0   rx       180.000 °
            | 4     90.000 ─────────┼━█───────    0.00   0.00   0.0   ry         0.000 °
            | 5    -90.000 ───────█━┼─────────    0.00   0.00   0.0   rz        90.000 °
            | 6      0.000 ─────────█─────────    0.00   0.00   0.0   speed      0.000 mm/s
            |─ Digital I/O ──────────────────────────────────────────────────────────────────
            | in         ········ ········ ········ ········ ········ ········ … 0/144 on
            | out        ········ ········ ········ ········ ········ ········ … 0/144 on
            | tool in    ········   out ········
            |─ Alarms (UTC) ─────────────────────────────────────────────────────────────────
            | 11:55:07 error 0x0f0034 collision
            | 11:55:07 protective stop
            |
            | q quit  p pause  Tab page  ↑↓ scroll  ? help  Overview I/O Measurements Alarms
        "#]],
    );
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
    check(
        &view,
        (80, 24),
        &expect![[r#"
            | jaka monitor  cell1 (10.5.5.100)                                 NO PACKET YET
            | rate – jitter – longest gap – skipped 0 unfit 0 reconnects 0
            |─ State ────────────────────────────────────────────────────────────────────────
            | Power           –         Enabled         –         In position     –
            | Protective stop –         Emergency stop  –         Drag mode       –
            | Program         –         Task mode       –         Rapid rate      –
            | Event           –
            |─ Joints ──────────────────────────────────────────────── TCP tool – user – ────
            |   position ° -360     0      360 current torque  temp   x              – mm
            | 1          – ···················       –      –     –   y              – mm
            | 2          – ···················       –      –     –   z              – mm
            | 3          – ···················       –      –     –   rx             – °
            | 4          – ···················       –      –     –   ry             – °
            | 5          – ···················       –      –     –   rz             – °
            | 6          – ···················       –      –     –   speed          – mm/s
            |─ Digital I/O ──────────────────────────────────────────────────────────────────
            | in         –
            | out        –
            | tool in    –  out –
            |─ Alarms (UTC) ─────────────────────────────────────────────────────────────────
            | none since the start
            |
            |
            | q quit  p pause  Tab page  ↑↓ scroll  ? help  Overview I/O Measurements Alarms
        "#]],
    );
}

#[test]
fn the_other_pages_show_all_there_is() {
    let mut view = at_work();
    view.page = Page::Io;
    check(
        &view,
        (80, 24),
        &expect![[r#"
            | jaka monitor  cell1 (10.5.5.100)                             ● live  age 20 ms
            | rate 20.0/s jitter 0.3 ms longest gap 61 ms skipped 0 unfit 0 reconnects 0
            |─ Inputs and outputs: cabinet ──────────────────────────────────────────────────
            | in         ···●···· ········ ········ ········ ········ ········ 2/144 on
            |   48       ········ ········ ········ ········ ········ ········
            |   96       ····●··· ········ ········ ········ ········ ········
            | out        ········ ········ ········ ········ ········ ········ 0/144 on
            |   48       ········ ········ ········ ········ ········ ········
            |   96       ········ ········ ········ ········ ········ ········
            | analog in  66 values, all 0
            | analog out 66 values, all 0
            | relays     –
            |─ Inputs and outputs: tool ─────────────────────────────────────────────────────
            | in         ●······· 1/8 on
            | out        ········ 0/8 on
            | analog in  1 values, all 0
            |
            |
            |
            |
            |
            |
            |
            | q quit  p pause  Tab page  ↑↓ scroll  ? help  Overview I/O Measurements Alarms
        "#]],
    );
    view.page = Page::Measurements;
    check(
        &view,
        (80, 30),
        &expect![[r#"
            | jaka monitor  cell1 (10.5.5.100)                             ● live  age 20 ms
            | rate 20.0/s jitter 0.3 ms longest gap 61 ms skipped 0 unfit 0 reconnects 0
            |─ Joints (no units stated by the protocol) ─────────────────────────────────────
            |                             1        2        3        4        5        6
            | position °            -170.25    90.00    45.50    90.00   -90.00   355.00
            | commanded °                 –        –        –        –        –        –
            | current                  0.00     0.00     0.00     0.00     0.00     0.00
            | voltage                  0.00     0.00     0.00     0.00     0.00     0.00
            | temperature              0.00     0.00     0.00     0.00     0.00     0.00
            | average power            0.00     0.00     0.00     0.00     0.00     0.00
            | current fluctuation      0.00     0.00     0.00     0.00     0.00     0.00
            | torque                   0.00     0.00     0.00     0.00     0.00     0.00
            | revolutions              0.00     0.00     0.00     0.00     0.00     0.00
            | running time             0.00     0.00     0.00     0.00     0.00     0.00
            | cycles since start       0.00     0.00     0.00     0.00     0.00     0.00
            | time since start         0.00     0.00     0.00     0.00     0.00     0.00
            |─ TCP ──────────────────────────────────────────────────────────────────────────
            |                          x mm     y mm     z mm     rx °     ry °     rz °
            | pose                   432.04   -41.43   811.67  -135.61    -3.50   -76.68
            | commanded                   –        –        –        –        –        –
            |─ Cabinet ──────────────────────────────────────────────────────────────────────
            | temperature              0.00
            | bus power                0.00
            | bus current              0.00
            | SCB version               0.0
            |─ Torque sensor ────────────────────────────────────────────────────────────────
            | works                      no
            | contact force            0.00     0.00     0.00     0.00     0.00     0.00
            | raw reading              0.00     0.00     0.00     0.00     0.00     0.00
            | q quit  p pause  Tab page  ↑↓ scroll  ? help  Overview I/O Measurements Alarms
        "#]],
    );
    let mut view = after_collision();
    view.page = Page::Alarms;
    check(
        &view,
        (80, 12),
        &expect![[r#"
            | jaka monitor  cell1 (10.5.5.100)                             ● live  age 20 ms
            | rate 20.0/s jitter 0.3 ms longest gap 61 ms skipped 0 unfit 0 reconnects 0
            |─ Alarms (UTC), the newest first ───────────────────────────────────────────────
            | 11:55:07 error 0x0f0034 collision
            | 11:55:07 protective stop
            |
            |
            |
            |
            |
            |
            | q quit  p pause  Tab page  ↑↓ scroll  ? help  Overview I/O Measurements Alarms
        "#]],
    );
}

#[test]
fn newer_firmware_has_fieldbuses() {
    let mut view = view(packet(Firmware::Newer, |state| state.analog_inputs[5] = 2.5));
    view.page = Page::Io;
    check(
        &view,
        (100, 40),
        &expect![[r#"
            | jaka monitor  cell1 (10.5.5.100)                                                 ● live  age 20 ms
            | rate 20.0/s jitter 0.3 ms longest gap 61 ms skipped 0 unfit 0 reconnects 0
            |─ Inputs and outputs: cabinet ──────────────────────────────────────────────────────────────────────
            | in         ········ ········ ········ ········ ········ ········ ········ ········ 0/199 on
            |   64       ········ ········ ········ ········ ········ ········ ········ ········
            |  128       ········ ········ ········ ········ ········ ········ ········ ········
            |  192       ·······
            | out        ········ ········ ········ ········ ········ ········ ········ ········ 0/199 on
            |   64       ········ ········ ········ ········ ········ ········ ········ ········
            |  128       ········ ········ ········ ········ ········ ········ ········ ········
            |  192       ·······
            | analog in  128 values, all others 0
            |            [5] 2.500
            | analog out 128 values, all 0
            | relays     ·· 0/2 on
            |─ Inputs and outputs: tool ─────────────────────────────────────────────────────────────────────────
            | in         ········ 0/8 on
            | out        ········ 0/8 on
            | analog in  2 values
            |            [0] 466.000   [1] 469.000
            |─ Modbus slave ─────────────────────────────────────────────────────────────────────────────────────
            | in         ········ ········ ········ ········ ········ ········ ········ ········ 0/128 on
            |   64       ········ ········ ········ ········ ········ ········ ········ ········
            | out        ········ ········ ········ ········ ········ ········ ········ ········ 0/128 on
            |   64       ········ ········ ········ ········ ········ ········ ········ ········
            | analog in  64 values, all 0
            | analog out 64 values, all 0
            |─ Profinet ─────────────────────────────────────────────────────────────────────────────────────────
            | in         ········ ········ ········ ········ ········ ········ ········ ········ 0/64 on
            | out        ········ ········ ········ ········ ········ ········ ········ ········ 0/64 on
            | analog in  64 values, all 0
            | analog out 64 values, all 0
            |─ EtherNet/IP ──────────────────────────────────────────────────────────────────────────────────────
            | in         ········ ········ ········ ········ ········ ········ ········ ········ 0/64 on
            | out        ········ ········ ········ ········ ········ ········ ········ ········ 0/64 on
            | analog in  48 values, all 0
            | analog out 48 values, all 0
            |
            |
            | q quit  p pause  Tab page  ↑↓ scroll  ? help                      Overview I/O Measurements Alarms
        "#]],
    );
}

#[test]
fn the_help_lies_over_the_page() {
    let mut view = at_work();
    view.help = true;
    check(
        &view,
        (80, 24),
        &expect![[r#"
            | jaka monitor  cell1 (10.5.5.100)                             ● live  age 20 ms
            | rate 20.0/s jitter 0.3 ms longest gap 61 ms skipped 0 unfit 0 reconnects 0
            |─ State ────────────────────────────────────────────────────────────────────────
            | Power           on        Enabled         yes       In position     yes
            | Protective stop no        Emergency stop  no        Drag mode       off
            | Program         idle      Task mode       manual    Rapid rate      100 %
            | Event       ┌─────────────────────── Keys ───────────────────────┐
            |─ Joints ────│ q, Esc, Ctrl-C           quit                      │0 user 0 ────
            |   position °│ p                        pause or continue         │32.041 mm
            | 1   -170.250│ Tab, → and Shift-Tab, ←  next page, previous page  │41.433 mm
            | 2     90.000│ 1 to 4                   go to a page              │11.670 mm
            | 3     45.500│ ↑ ↓ PgUp PgDn Home       scroll                    │35.609 °
            | 4     90.000│ ?                        this help                 │-3.502 °
            | 5    -90.000│                                                    │76.679 °
            | 6    355.000│ Nothing is ever sent to the robot. Values that a   │ 0.000 mm/s
            |─ Digital I/O│ packet does not have are shown as –. Status packets│─────────────
            | in         ·│ do not say whether servo mode is on.               │ 2/144 on
            | out        ·└────────────────────────────────────────────────────┘ 0/144 on
            | tool in    ●·······   out ········
            |─ Alarms (UTC) ─────────────────────────────────────────────────────────────────
            | none since the start
            |
            |
            | q quit  p pause  Tab page  ↑↓ scroll  ? help  Overview I/O Measurements Alarms
        "#]],
    );
}

/// The colour of the first cell of a text on the screen.
fn colour(buffer: &Buffer, wanted: &str) -> Color {
    let rows = rows(buffer);
    let (row, line) = rows.iter().enumerate().find(|(_, line)| line.contains(wanted)).expect(wanted);
    let column = line[..line.find(wanted).unwrap()].chars().count();
    buffer.content[row * usize::from(buffer.area.width) + column].fg
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
