//! Each command of the spec does something: a query gives back a setting, port 10000 shows a motion, a wrong state is
//! refused.
//!
//! A module for each topic of the document lists its commands with the test of each. These lists are written by hand,
//! so that no command of the document loses its test unnoticed; the document is complete, so they do not grow. Settings
//! that a query gives back are taken from the spec, and so are commands beyond the document, whose examples are sent.
//! Time goes on when a test says so.

#[macro_use]
mod arm;
mod beyond;
mod collision;
mod force;
mod frames;
mod io;
mod kinematics;
mod motion;
mod network;
mod payload;
mod power;
mod program;
mod remembered;
mod servo;
mod session;
mod torque_sensor;
mod trajectory;
mod variables;

use jaka_sync::proto::Request;

/// The commands of the document that have a test, by topic.
const COVERED: &[&[&str]] = &[
    power::COVERED,
    motion::COVERED,
    servo::COVERED,
    program::COVERED,
    io::COVERED,
    frames::COVERED,
    variables::COVERED,
    payload::COVERED,
    collision::COVERED,
    kinematics::COVERED,
    trajectory::COVERED,
    force::COVERED,
    torque_sensor::COVERED,
    network::COVERED,
    session::COVERED,
];

#[test]
fn each_command_of_the_document_has_one_test() {
    let of_document = Request::COMMANDS.iter().filter(|info| !info.section.is_empty());
    let mut all: Vec<_> = of_document.map(|info| info.name).collect();
    let mut covered = COVERED.concat();
    // Those whose pair the spec names need no row, and may have one for more than that they are remembered.
    let remembered: Vec<_> = remembered::covered().into_iter().filter(|name| !covered.contains(name)).collect();
    covered.extend(remembered.into_iter().filter(|name| all.contains(name)));
    covered.sort_unstable();
    all.sort_unstable();
    assert_eq!(covered, all);
}
