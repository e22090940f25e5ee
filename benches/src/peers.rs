//! Messages by serde's derives, for comparison with the usual approach.

use serde::{Deserialize, Serialize};
use serde_json::Value;

/// `servo_j`.
#[derive(Debug, Clone, Serialize)]
#[serde(tag = "cmdName", rename = "servo_j")]
#[expect(non_snake_case, missing_docs, reason = "the wire's names")]
pub struct ServoJ {
    pub relFlag: i64,
    pub jointPosition: [f64; 6],
    pub stepNum: Option<i64>,
}

/// The reply of `get_joint_pos`.
#[derive(Debug, Clone, Deserialize)]
#[expect(non_snake_case, missing_docs, reason = "the wire's names")]
pub struct JointPosReply<'a> {
    pub errorCode: &'a str,
    #[serde(default)]
    pub errorMsg: &'a str,
    pub cmdName: &'a str,
    pub joint_pos: [f64; 6],
}

/// The payload of the same reply, taken out of a `Value`.
#[derive(Debug, Clone, Deserialize)]
#[expect(missing_docs, reason = "the wire's names")]
pub struct JointPos {
    pub joint_pos: [f64; 6],
}

/// One field of a status packet.
#[derive(Debug, Clone, Deserialize)]
#[expect(missing_docs, reason = "the wire's names")]
pub struct Joints {
    pub joint_actual_position: Option<[f64; 6]>,
}

/// A status packet, as one would write it down without leniency.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
#[expect(non_snake_case, missing_docs, reason = "the wire's names")]
pub struct Status {
    pub len: Option<i64>,
    pub drag_status: Option<bool>,
    pub extio: Option<Extio>,
    pub errcode: Option<String>,
    pub errmsg: Option<String>,
    pub monitor_data: Option<MonitorData>,
    pub torqsensor: Option<TorqueSensor>,
    pub joint_actual_position: Option<[f64; 6]>,
    pub actual_position: Option<[f64; 6]>,
    pub din: Option<Vec<u8>>,
    pub dout: Option<Vec<u8>>,
    pub ain: Option<Vec<f64>>,
    pub aout: Option<Vec<f64>>,
    pub tio_din: Option<Vec<u8>>,
    pub tio_dout: Option<Vec<u8>>,
    pub tio_ain: Option<Vec<f64>>,
    pub task_state: Option<i64>,
    pub homed: Option<Vec<u8>>,
    pub task_mode: Option<i64>,
    pub interp_state: Option<i64>,
    pub enabled: Option<bool>,
    pub paused: Option<bool>,
    pub rapidrate: Option<f64>,
    pub current_tool_id: Option<i64>,
    pub current_user_id: Option<i64>,
    pub on_soft_limit: Option<i64>,
    pub emergency_stop: Option<i64>,
    pub drag_near_limit: Option<Vec<i64>>,
    pub funcdi: Option<Vec<[i64; 2]>>,
    pub powered_on: Option<i64>,
    pub inpos: Option<bool>,
    pub motion_mode: Option<i64>,
    pub curr_tcp_trans_vel: Option<f64>,
    pub protective_stop: Option<i64>,
    pub point_key: Option<i64>,
    pub netState: Option<i64>,
    pub joint_position: Option<[f64; 6]>,
    pub position: Option<[f64; 6]>,
    pub tio_key: Option<Vec<i64>>,
    pub instVel: Option<Vec<f64>>,
    pub relay_io: Option<Vec<u8>>,
    pub mb_slave_din: Option<Vec<u8>>,
    pub mb_slave_dout: Option<Vec<u8>>,
    pub mb_slave_ain: Option<Vec<f64>>,
    pub mb_slave_aout: Option<Vec<f64>>,
    pub pn_dev_din: Option<Vec<u8>>,
    pub pn_dev_dout: Option<Vec<u8>>,
    pub pn_dev_ain: Option<Vec<f64>>,
    pub pn_dev_aout: Option<Vec<f64>>,
    pub eip_adpt_din: Option<Vec<u8>>,
    pub eip_adpt_dout: Option<Vec<u8>>,
    pub eip_adpt_ain: Option<Vec<f64>>,
    pub eip_adpt_aout: Option<Vec<f64>>,
    pub tio_rs_signals: Option<Value>,
    pub motion_line: Option<i64>,
    pub err_add_line: Option<i64>,
}

/// Measurements in the cabinet and the joints.
pub type MonitorData = (i64, i64, f64, f64, f64, Vec<Vec<f64>>);

/// Settings and state of the torque sensor.
pub type TorqueSensor = ((i64, (String, i64), (f64, [f64; 3])), (u8, i64, [f64; 6], [f64; 6]));

/// The extension I/O modules.
#[derive(Debug, Clone, Deserialize)]
#[expect(missing_docs, reason = "the wire's names")]
pub struct Extio {
    pub status: (Vec<u8>, Vec<u8>, Vec<f64>, Vec<f64>),
    pub setup: Vec<(i64, String, Value, [[i64; 2]; 4])>,
    pub num: i64,
    pub pinmap: Vec<[i64; 4]>,
    pub mode: i64,
}
