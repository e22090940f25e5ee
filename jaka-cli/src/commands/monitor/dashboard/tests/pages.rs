//! Contents of each page.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use expect_test::expect;
use jaka_sim::Firmware;
use ratatui::Terminal;
use ratatui::backend::TestBackend;

use super::{after_collision, at_work, check, packet, rows, view};
use crate::commands::monitor::dashboard::draw;
use crate::commands::monitor::dashboard::view::Page;

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
            | 11:55:07   remedy: look for obstacles around the arm and for signs of a
            |            collision; check whether the robot's serial number and model are
            |            recognised correctly; check the settings of payload and mounting
            |            angle
            | 11:55:07 protective stop
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
