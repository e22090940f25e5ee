//! The reply of `get_joint_pos`: whose it is, whether it was accepted, and six floats.

use jaka_proto::messages::types::JointPosition;

use super::scan::Scan;

/// Contents of the reply.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointPosReply<'a> {
    /// `cmdName`.
    pub command: &'a str,
    /// `errorMsg`; empty if it is absent.
    pub message: &'a str,
    /// The position.
    pub joint_position: JointPosition,
}

/// Reads the reply; `None` if it is a refusal, or anything but such a reply in plain JSON.
pub fn read(text: &str) -> Option<JointPosReply<'_>> {
    let mut scan = Scan::new(text);
    let (mut code, mut command, mut message, mut joints) = (None, None, None, None);
    scan.blank();
    scan.need(b"{")?;
    loop {
        let twice = if scan.eat(br#""errorCode":"#) {
            scan.blank();
            code.replace(error_code(&mut scan)?).is_some()
        } else if scan.eat(br#""errorMsg":"#) {
            scan.blank();
            message.replace(scan.text()?).is_some()
        } else if scan.eat(br#""cmdName":"#) {
            scan.blank();
            command.replace(scan.text()?.trim()).is_some()
        } else if scan.eat(br#""joint_pos":"#) {
            scan.blank();
            joints.replace(scan.array::<f64, 6>(Scan::float)?).is_some()
        } else {
            return None;
        };
        if twice {
            return None;
        }
        if !scan.comma(b'}')? {
            break;
        }
    }
    scan.end()?;
    let accepted = code? == 0;
    let reply = JointPosReply { command: command?, message: message.unwrap_or(""), joint_position: joints?.into() };
    accepted.then_some(reply)
}

fn error_code(scan: &mut Scan<'_>) -> Option<i64> {
    if !scan.eat(b"\"") {
        return scan.int();
    }
    let code = scan.int()?;
    scan.eat(b"\"").then_some(code)
}
