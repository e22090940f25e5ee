//! An arm in servo mode, set-point by set-point, on a clock that the test moves on.

use std::time::Duration;

use super::{Peer, assert_accepted, enabled};
use jaka_sim::{Builder, Controller, Delays, Firmware, Habits, State};

pub(crate) const CYCLE: Duration = Duration::from_millis(8);

/// Options of a controller whose packets have commanded positions.
pub(crate) fn builder() -> Builder {
    let builder = Controller::builder().firmware(Firmware::Newer).habits(Habits::none()).delays(Delays::NONE);
    builder.stepped_clock().status_period(Duration::MAX)
}

/// A controller whose arm is in servo mode, and its client.
#[derive(Debug)]
pub(crate) struct Arm {
    pub(crate) controller: Controller,
    pub(crate) peer: Peer,
}

impl Arm {
    /// In servo mode.
    pub(crate) fn new(builder: Builder) -> Self {
        Self::with_filter(builder, r#""filter_type":0"#)
    }

    /// In servo mode, with a filter.
    pub(crate) fn with_filter(builder: Builder, filter: &str) -> Self {
        let controller = enabled(builder);
        let peer = Peer::commands(&controller);
        let mut arm = Self { controller, peer };
        let request = format!(r#"{{"cmdName":"set_servo_move_filter",{filter}}}"#);
        assert_accepted(&arm.peer.ask(&request), "set_servo_move_filter");
        arm.enter();
        arm
    }

    pub(crate) fn enter(&mut self) {
        assert_accepted(&self.peer.ask(r#"{"cmdName":"servo_move","relFlag":1}"#), "servo_move");
        assert!(self.controller.state().servo_mode);
    }

    /// Sends a set-point, the first joint's, whose place is its offset from where it starts.
    pub(crate) fn send(&mut self, place: f64) {
        let request = set_point(place);
        assert_accepted(&self.peer.ask(&request), "servo_j");
    }

    /// The state after one cycle more.
    pub(crate) fn step(&self) -> State {
        self.controller.advance(CYCLE);
        self.controller.state()
    }

    /// Sends these places, one each cycle, and gives the state after each.
    pub(crate) fn follow(&mut self, places: impl IntoIterator<Item = f64>) -> Vec<State> {
        let step = |place| {
            self.send(place);
            self.step()
        };
        places.into_iter().map(step).collect()
    }

    /// The states of each cycle until the arm is at rest.
    pub(crate) fn until_rest(&self) -> Vec<State> {
        let mut states = Vec::new();
        while states.last().is_none_or(|state: &State| !state.at_rest) {
            assert!(states.len() < 10_000, "the arm comes to rest");
            states.push(self.step());
        }
        states
    }
}

/// A set-point of the first joint, which starts at 0.
pub(crate) fn set_point(place: f64) -> String {
    format!(r#"{{"cmdName":"servo_j","relFlag":0,"jointPosition":[{place},90,90,90,-90,0],"stepNum":1}}"#)
}

/// Places at a constant speed in deg/s.
pub(crate) fn ramp(speed: f64, cycles: u32) -> impl Iterator<Item = f64> {
    (1..=cycles).map(move |n| f64::from(n) * speed * CYCLE.as_secs_f64())
}

/// Actual position of the first joint, in degrees.
pub(crate) fn actual(state: &State) -> f64 {
    state.joint_position.0[0]
}

/// Commanded position of the first joint, in degrees.
pub(crate) fn commanded(state: &State) -> f64 {
    state.joint_commanded_position.0[0]
}

/// The greatest speed, acceleration and jerk of values that were constant before, by differences.
pub(crate) fn greatest(values: &[f64]) -> [f64; 3] {
    let mut values = [vec![values[0]; 3], values.to_vec()].concat();
    [(); 3].map(|()| {
        values = values.windows(2).map(|pair| (pair[1] - pair[0]) / CYCLE.as_secs_f64()).collect();
        values.iter().map(|value| value.abs()).fold(0.0, f64::max)
    })
}
