//! Requests of seven kinds, each written by its own code: text that never changes in as few pieces as can be.

use jaka_proto::messages::force::SetTorqueSensorComm;
use jaka_proto::messages::io::SetDigitalOutput;
use jaka_proto::messages::kinematics::KineInverse;
use jaka_proto::messages::motion::{Jog, JointMove};
use jaka_proto::messages::servo::ServoJ;
use jaka_proto::messages::variables::ModifyUserDefinedVariable;

/// Writes `joint_move`: an enum, six floats, two more.
pub fn joint_move(request: &JointMove, out: &mut Vec<u8>) {
    out.extend_from_slice(br#"{"cmdName":"joint_move","relFlag":"#);
    int(request.mode.into(), out);
    out.extend_from_slice(br#","jointPosition":["#);
    floats(&request.joint_position.0, out);
    out.extend_from_slice(br#"],"speed":"#);
    float(request.speed, out);
    if let Some(acceleration) = request.acceleration {
        out.extend_from_slice(br#","accel":"#);
        float(acceleration, out);
    }
    out.push(b'}');
}

/// Writes `servo_j`: an enum, six floats, a whole number.
pub fn servo_j(request: &ServoJ, out: &mut Vec<u8>) {
    out.extend_from_slice(br#"{"cmdName":"servo_j","relFlag":"#);
    int(request.mode.into(), out);
    out.extend_from_slice(br#","jointPosition":["#);
    floats(&request.joint_position.0, out);
    if let Some(steps) = request.step_count {
        out.extend_from_slice(br#"],"stepNum":"#);
        int(steps, out);
        out.push(b'}');
    } else {
        out.extend_from_slice(b"]}");
    }
}

/// Writes `jog`, which has variants.
pub fn jog(request: &Jog, out: &mut Vec<u8>) {
    let (head, frame, axis) = match request {
        Jog::Stop { frame, axis, .. } => (br#"{"cmdName":"jog","jog_mode":0,"coord_map":"#, frame, axis),
        Jog::Continuous { frame, axis, .. } => (br#"{"cmdName":"jog","jog_mode":1,"coord_map":"#, frame, axis),
        Jog::Increment { frame, axis, .. } => (br#"{"cmdName":"jog","jog_mode":2,"coord_map":"#, frame, axis),
        Jog::Absolute { frame, axis, .. } => (br#"{"cmdName":"jog","jog_mode":3,"coord_map":"#, frame, axis),
        _ => return,
    };
    out.extend_from_slice(head);
    int((*frame).into(), out);
    out.extend_from_slice(br#","jnum":"#);
    int(*axis, out);
    if let Jog::Continuous { velocity, .. } | Jog::Increment { velocity, .. } | Jog::Absolute { velocity, .. } = request
    {
        out.extend_from_slice(br#","jogvel":"#);
        float(*velocity, out);
    }
    if let Jog::Increment { distance: last, .. } | Jog::Absolute { position: last, .. } = request {
        out.extend_from_slice(br#","poscmd":"#);
        float(*last, out);
    }
    out.push(b'}');
}

/// Writes `set_digital_output`: whole numbers.
pub fn set_digital_output(request: &SetDigitalOutput, out: &mut Vec<u8>) {
    out.extend_from_slice(br#"{"cmdName":"set_digital_output","type":"#);
    int(request.kind.into(), out);
    out.extend_from_slice(br#","index":"#);
    int(request.index, out);
    out.extend_from_slice(br#","value":"#);
    int(request.value.into(), out);
    out.push(b'}');
}

/// Writes `set_torque_sensor_comm`: an enum, a string, a whole number.
pub fn set_torque_sensor_comm(request: &SetTorqueSensorComm, out: &mut Vec<u8>) {
    out.extend_from_slice(br#"{"cmdName":"set_torque_sensor_comm","type":"#);
    int(request.communication.into(), out);
    out.extend_from_slice(br#","ip_addr":"#);
    text(&request.address, out);
    out.extend_from_slice(br#","port":"#);
    int(request.port, out);
    out.push(b'}');
}

/// Writes `modify_user_defined_variable`: a whole number, a string, a float.
pub fn modify_variable(request: &ModifyUserDefinedVariable, out: &mut Vec<u8>) {
    out.extend_from_slice(br#"{"cmdName":"modify_user_defined_variable","id_new":"#);
    int(request.id, out);
    out.extend_from_slice(br#","alias_new":"#);
    text(&request.alias, out);
    out.extend_from_slice(br#","value_new":"#);
    float(request.value, out);
    out.push(b'}');
}

/// Writes `kine_inverse`: two arrays of six floats, one of them a struct.
pub fn kine_inverse(request: &KineInverse, out: &mut Vec<u8>) {
    out.extend_from_slice(br#"{"cmdName":"kine_inverse","jointPosition":["#);
    floats(&request.reference_joint_position.0, out);
    out.extend_from_slice(br#"],"cartPosition":["#);
    floats(&request.pose.into(), out);
    out.extend_from_slice(b"]}");
}

fn floats(values: &[f64; 6], out: &mut Vec<u8>) {
    float(values[0], out);
    for value in &values[1..] {
        out.push(b',');
        float(*value, out);
    }
}

#[inline]
fn float(value: f64, out: &mut Vec<u8>) {
    if !value.is_finite() {
        return out.extend_from_slice(b"null");
    }
    let mut buffer = zmij::Buffer::new();
    let text = buffer.format_finite(value).as_bytes();
    out.extend_from_slice(text.strip_suffix(b".0").unwrap_or(text));
}

#[inline]
fn int(value: i64, out: &mut Vec<u8>) {
    match u8::try_from(value) {
        Ok(digit @ 0..=9) => out.push(b'0' + digit),
        _ => out.extend_from_slice(itoa::Buffer::new().format(value).as_bytes()),
    }
}

#[inline]
fn text(value: &str, out: &mut Vec<u8>) {
    out.push(b'"');
    let mut rest = value.as_bytes();
    while let Some(at) = rest.iter().position(|byte| *byte < 0x20 || matches!(byte, b'"' | b'\\')) {
        out.extend_from_slice(&rest[..at]);
        escape(rest[at], out);
        rest = &rest[at + 1..];
    }
    out.extend_from_slice(rest);
    out.push(b'"');
}

#[cold]
fn escape(byte: u8, out: &mut Vec<u8>) {
    match byte {
        b'"' | b'\\' => out.extend_from_slice(&[b'\\', byte]),
        b'\n' => out.extend_from_slice(b"\\n"),
        b'\r' => out.extend_from_slice(b"\\r"),
        b'\t' => out.extend_from_slice(b"\\t"),
        _ => out.extend_from_slice(format!("\\u{byte:04x}").as_bytes()),
    }
}
