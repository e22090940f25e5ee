//! Firmware, by the form of its messages and its behaviour.

mod shape;
mod values;
mod writing;

use std::fmt;
use std::time::Duration;

pub(crate) use self::shape::{Shape, TOOL_DIGITAL};
pub(crate) use self::values::Values;
pub(crate) use self::writing::Writing;
use jaka_proto::messages::status::TaskState;

use crate::{Habit, Habits};

/// Generates the enum of a table of firmwares, with a row for each: a firmware without a [`Shape`] does not compile.
macro_rules! firmwares {
    (
        $(#[$meta:meta])*
        pub enum $Firmware:ident;
        $( $(#[$row_meta:meta])* $Name:ident => $shape:expr; )*
    ) => {
        $(#[$meta])*
        pub enum $Firmware {
            $( $(#[$row_meta])* $Name ),*
        }

        impl $Firmware {
            /// All firmwares.
            pub const ALL: &'static [Self] = &[$(Self::$Name),*];

            pub(crate) const fn shape(self) -> &'static Shape {
                match self {
                    $(Self::$Name => const { &$shape }),*
                }
            }
        }
    };
}

firmwares! {
    /// Firmware of a controller.
    ///
    /// It determines the keys and the period of status packets, the numbers of inputs and outputs, the form of replies,
    /// the version in `get_version`, and undocumented behaviour.
    /// [`Builder::status_period`](crate::Builder::status_period) and [`Builder::habits`](crate::Builder::habits) take
    /// precedence over it.
    ///
    /// | | `V1_5_14` | `Newer` | `Document` |
    /// |---|---|---|---|
    /// | `get_version` | `1.5.14_13_X64` | `1.7.2` | `1.6.5_01_X86` |
    /// | digital inputs, digital outputs | 135 | 199 | 144 |
    /// | analog inputs, analog outputs | 64 | 128 | 66 |
    /// | analog inputs of the tool | 2 | 2 | 1 |
    /// | values for each joint in the monitor data | 11 | 11 | 10 |
    /// | elements of the monitor data, readings of the torque sensor | 6, 2 | 10, 3 | 6, 2 |
    /// | extension I/O modules in packets | no | yes | yes |
    /// | numbers that may have a fraction | `3.0` | `3.0` | `3` |
    /// | whole numbers | `3` | `3` | `3` |
    /// | decimals of joint positions in packets, of positions in replies | 5, 6 | 5, 6 | any |
    /// | decimals of poses in packets | 5 | 13 | any |
    /// | `task_state` of a disabled arm with power | 3 | 3 | 2 |
    /// | initial functions with an input | none | none | as in the document's sample |
    /// | blanks after commas and colons | yes | yes | no |
    /// | event in `get_robot_state` | no | a number | no |
    /// | states in `get_robot_state` | document's words | `"True"`, `"False"` | document's words |
    /// | period of packets | 30 ms | 50 ms | 50 ms |
    /// | initial packet | 3.1 KB | 8.8 KB | 2.0 KB |
    /// | habits | `late-power`, `servo-at-rest`, `disable-moving`, `events` | `servo-at-rest`, `events` | none |
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
    #[non_exhaustive]
    pub enum Firmware;

    /// Firmware 1.5.14, by a packet, transcripts and a timed log of such a controller.
    #[default]
    V1_5_14 => Shape {
        name: "1.5.14",
        version: "1.5.14_13_X64",
        status_period: Duration::from_millis(30),
        writing: Writing::Capture,
        habits: &[Habit::LatePower, Habit::ServoAtRest, Habit::DisableMoving, Habit::Events],
        extio: false,
        newer_keys: false,
        digital: 135,
        analog: 64,
        tool_analog: &[474.0, 474.0],
        no_function_input: true,
        disabled: TaskState::Disabled,
        pose_decimals: 5,
        monitor_head: "12338,12593,47.0,0.0,0.0",
        joint_row: "0.0,48.0,28.0,0.0,0.10000000149011612,30363.5,390097.0,0.0,1.0,0.0,-1.0188410813171915",
        monitor_tail: "",
        torque_readings: 2,
        extio_module_id: None,
    };

    /// Firmware newer than the document, by a capture of the packets of such a controller: they have more than the 5000
    /// bytes that the document allows.
    ///
    /// `get_robot_state` answers in the form of packets. The version that sent the captured packets is unknown.
    Newer => Shape {
        name: "newer",
        version: "1.7.2",
        status_period: Duration::from_millis(50),
        writing: Writing::AsPackets,
        habits: &[Habit::ServoAtRest, Habit::Events],
        extio: true,
        newer_keys: true,
        digital: 199,
        analog: 128,
        tool_analog: &[466.0, 469.0],
        no_function_input: true,
        disabled: TaskState::Disabled,
        pose_decimals: 13,
        monitor_head: "12338,12593,49.0,26.0,1.0720000267028809",
        joint_row: "0.06650000065565109,23.0,50.0,0.0,0.10000000149011612,6007.2001953125,2888860.0,2.5999999046325684,110602.0,0.3330000042915344,-0.06700000166893005",
        monitor_tail: ",0,0,0,23.39",
        torque_readings: 3,
        extio_module_id: Some("ext_0f5118ef9a5cb05b"),
    };

    /// Messages as printed in the document, version 2.0.4, without blanks. No known controller writes this form.
    Document => Shape {
        name: "document",
        version: "1.6.5_01_X86",
        status_period: Duration::from_millis(50),
        writing: Writing::Document,
        habits: &[],
        extio: true,
        newer_keys: false,
        digital: 144,
        analog: 66,
        tool_analog: &[0.0],
        no_function_input: false,
        disabled: TaskState::PoweredOn,
        pose_decimals: 5,
        monitor_head: "0,0,0,0,0",
        joint_row: "0,0,0,0,0,0,0,0,0,0",
        monitor_tail: "",
        torque_readings: 2,
        extio_module_id: None,
    };
}

impl Firmware {
    /// Returns the name for input: `1.5.14`, `newer` or `document`.
    pub fn name(self) -> &'static str {
        self.shape().name
    }

    /// Returns the period of its status packets.
    pub fn status_period(self) -> Duration {
        self.shape().status_period
    }

    /// Returns the undocumented habits of the firmware.
    pub fn habits(self) -> Habits {
        self.shape().habits.iter().copied().collect()
    }
}

/// Writes the [`name`](Firmware::name).
impl fmt::Display for Firmware {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
