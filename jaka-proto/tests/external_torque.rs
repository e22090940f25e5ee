//! Measured torques minus those of the model.

use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode as _, Reader};

/// A packet with these rows of joints; the last value of a row is the torque of the model.
fn packet(powered: &str, rows: &[&str]) -> RobotStatus {
    let text = format!(
        r#"{{"powered_on": {powered}, "monitor_data": [12338, 12593, 51.0, 0.0, 0.0, [{}]]}}"#,
        rows.join(", ")
    );
    RobotStatus::decode(&mut Reader::new(&text)).expect("it is a packet")
}

const ROW: &str = "[-1.446, 48.0, 28.0, 0.0, 0.1, 30363.5, 390097.0, 0.0, 1.0, -7.23, -7.19]";
const TEN: &str = "[-1.446, 48.0, 28.0, 0.0, 0.1, 30363.5, 390097.0, 0.0, 1.0, -7.23]";

#[test]
fn they_are_the_difference_of_both() {
    let torques = packet("1", &[ROW; 6]).external_torques().expect("both are there");
    assert!(torques.iter().all(|torque| (torque - -0.04).abs() < 1e-9), "{torques:?}");
}

#[test]
fn without_both_for_each_joint_or_without_power_there_are_none() {
    for (powered, rows) in [("1", &[TEN; 6][..]), ("1", &[ROW; 5]), ("1", &[ROW; 7]), ("0", &[ROW; 6])] {
        assert_eq!(packet(powered, rows).external_torques(), None, "{powered} {rows:?}");
    }
    assert_eq!(packet("1", &[ROW, ROW, TEN, ROW, ROW, ROW]).external_torques(), None);
    assert_eq!(RobotStatus::default().external_torques(), None);
}
