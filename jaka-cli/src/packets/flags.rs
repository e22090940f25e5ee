//! On/off states of the robot, and their changes.

use jaka_sync::status::RobotStatus;

/// Severity of a change.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Tone {
    /// The robot stopped, or its state is not known.
    Bad,
    /// The robot needs attention.
    Warning,
    /// A bad state has ended.
    Good,
    /// Other change.
    Plain,
}

/// On/off states in packets. A packet without a field does not change its state.
#[derive(Debug, Default)]
pub(crate) struct Flags([Option<bool>; 4]);

impl Flags {
    /// Takes a packet, and returns the changes from the previous ones. For the first packet, it only returns active
    /// stops.
    pub(crate) fn see(&mut self, status: &RobotStatus) -> Vec<(Tone, &'static str)> {
        let flags = [
            (status.emergency_stop, true, ["emergency stop released", "emergency stop"]),
            (status.protective_stop, true, ["protective stop cleared", "protective stop"]),
            (status.powered_on, false, ["power off", "power on"]),
            (status.enabled, false, ["disabled", "enabled"]),
        ];
        let changes = flags.into_iter().zip(&mut self.0).filter_map(|((now, is_stop, texts), last)| {
            let before = last.or(is_stop.then_some(false));
            *last = now.or(*last);
            let tone = match (is_stop, now?) {
                (true, true) => Tone::Bad,
                (true, false) => Tone::Good,
                (false, _) => Tone::Plain,
            };
            (before? != now?).then(|| (tone, texts[usize::from(now == Some(true))]))
        });
        changes.collect()
    }
}
