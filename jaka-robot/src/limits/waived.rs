//! Settings of the controller that presets of accelerations require.

use jaka_motion::Preset;
use jaka_proto::messages::collision::GetClsnSensitivity;
use jaka_proto::messages::payload::GetPayload;

use crate::Error;
use crate::arm::Arm;
use crate::error::OptionName;

/// Requirements of presets that a program waives.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Waived {
    pub(crate) payload: bool,
    pub(crate) collision_detection: bool,
}

impl Waived {
    /// Reads the payload and the collision level, if a preset requires them.
    pub(crate) fn check(self, arm: &mut Arm, preset: Preset) -> Result<(), Error> {
        if preset == Preset::Gentle {
            return Ok(());
        }
        let name = preset.name();
        if !self.payload {
            let payload = arm.queries().call(&GetPayload::new())?;
            log::info!(target: "jaka_robot", "preset `{name}` with a payload of {} kg", payload.mass);
        }
        if !self.collision_detection && arm.queries().call(&GetClsnSensitivity::new())?.level == 0 {
            let given = format_args!("the preset `{name}` with the collision level 0");
            let expected = "a level above 0 (`set_clsn_sensitivity`), or `RobotConfig::without_collision_detection`";
            return Err(OptionName::new("RobotConfig", "limits").refuse(given, expected.to_owned()));
        }
        Ok(())
    }
}
