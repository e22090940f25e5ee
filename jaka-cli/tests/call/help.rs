//! Texts of the help and of the list.

use expect_test::{expect, expect_file};

use crate::program::{jaka, pack};

#[test]
fn the_help_of_a_motion() {
    expect_file!["../snapshots/joint_move.txt"].assert_eq(&jaka(["call", "joint_move", "--help"]).text());
}

#[test]
fn the_short_help_of_a_command_with_variants() {
    expect_file!["../snapshots/jog.txt"].assert_eq(&jaka(["call", "jog", "-h"]).text());
}

#[test]
fn the_help_of_a_query() {
    expect_file!["../snapshots/get_extio_status.txt"].assert_eq(&jaka(["call", "get_extio_status", "--help"]).text());
}

#[test]
fn the_list_has_all_commands() {
    let list = jaka(["call", "--list"]);
    expect_file!["../snapshots/list.txt"].assert_eq(&list.text());
    assert_eq!(jaka(["call"]).out, list.out);
}

#[test]
fn the_list_of_one_topic() {
    expect![[r"
        payload: Payload
          set_payload  Sets the mass and the centroid of the payload.
          get_payload  Reads the mass and the centroid of the payload.
        exit code 0
    "]]
    .assert_eq(&jaka(["call", "--list", "payload"]).text());
    expect![[r"
        error: there is no topic `joints`; the topics are power, motion, servo, program, io, frames, variables, payload, collision, kinematics, trajectory, force, network, session, beyond_state, beyond_io, beyond_settings
        exit code 2
    "]].assert_eq(&jaka(["call", "--list", "joints"]).text());
    expect![[r"
        newer: What newer firmware adds
          demo_motion_state                 Reads how the motion stands.
          demo_stop_state                   Reads whether the emergency stop is pressed.
          demo_set_period, set_demo_period  Sets the time between two status packets.
        exit code 0
    "]]
    .assert_eq(&jaka(["call", "--list", "newer", "--pack", &pack("newer.toml")]).text());
}
