//! Connections of the tests of stops.

use super::*;

/// Robot whose packets have shown no stop.
struct Quiet;

impl AttachedRobot for Quiet {
    fn stopped(&self) {}

    fn is_latched(&self) -> bool {
        false
    }
}

/// Stops of a connection with a robot.
pub(super) fn with_robot() -> Arc<Stops> {
    let stops = Stops::new(&Clock::default());
    assert!(stops.attach(Quiet), "it has none");
    stops
}
