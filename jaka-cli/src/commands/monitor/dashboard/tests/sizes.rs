//! Contents of windows of various sizes.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use expect_test::expect;
use jaka_sync::status::RobotStatus;

use super::{after_collision, at_work, check, screen, view};
use crate::commands::monitor::dashboard::view::Page;

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
