//! A server that does as little as can be: each request is answered at once with the message that is printed here.
//!
//! It is the same for all who are compared, so that what differs is the client's side.

use std::io::{self, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::thread;

/// A request without fields.
pub const JOINTS_REQUEST: &[u8] = br#"{"cmdName":"get_joint_pos"}"#;

/// Its reply, of a fixed shape, with floats in full precision, spaced as controllers do.
pub const JOINTS_REPLY: &[u8] = br#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_joint_pos", "joint_pos": [-12.354189, 89.99987654321012, 45.123456, -90.000314159265, 0.001235, 178.98765432109877]}"#;

const SET_POINT_REPLY: &[u8] = br#"{"errorCode": "0", "errorMsg": "", "cmdName": "servo_j"}"#;

const POSE_REPLY: &[u8] = br#"{"errorCode": "0", "errorMsg": "", "cmdName": "get_tcp_pos", "tcp_pos": [-458.6, 13.9, 443.8, 179.4, 1.2, 96.8]}"#;

const SERVO_MODE_REPLY: &[u8] = br#"{"errorCode": "0", "errorMsg": "", "cmdName": "servo_move"}"#;

const IN_SERVO_MODE_REPLY: &[u8] =
    br#"{"errorCode": "0", "errorMsg": "", "in_servomove": true, "cmdName": "is_in_servomove"}"#;

const NOT_IN_SERVO_MODE_REPLY: &[u8] =
    br#"{"errorCode": "0", "errorMsg": "", "in_servomove": false, "cmdName": "is_in_servomove"}"#;

/// Serves each client in a thread of its own.
///
/// # Errors
/// No more connections are accepted.
pub fn serve(listener: &TcpListener) -> io::Result<()> {
    loop {
        let (stream, _) = listener.accept()?;
        stream.set_nodelay(true)?;
        // A client that is gone is not an error.
        thread::spawn(move || attend(stream).ok());
    }
}

/// Takes connections and sends nothing: a status port without news.
///
/// # Errors
/// No more connections are accepted.
pub fn keep_silent(listener: &TcpListener) -> io::Result<()> {
    let mut readers = Vec::new();
    loop {
        readers.push(listener.accept()?);
    }
}

fn attend(mut stream: TcpStream) -> io::Result<()> {
    let (mut buffer, mut end, mut out, mut in_servo_mode) = (vec![0; 64 << 10], 0, Vec::new(), false);
    loop {
        let len = stream.read(&mut buffer[end..])?;
        if len == 0 {
            return Ok(());
        }
        end += len;
        let mut start = 0;
        // No request in use here has an object inside.
        while let Some(len) = buffer[start..end].iter().position(|byte| *byte == b'}') {
            let request = &buffer[start..=start + len];
            let name = request.split(|byte| *byte == b'"').nth(3).unwrap_or_default();
            if name == b"servo_move" {
                in_servo_mode = request.ends_with(b":1}");
            }
            out.extend_from_slice(match name {
                b"servo_j" => SET_POINT_REPLY,
                b"get_joint_pos" => JOINTS_REPLY,
                b"get_tcp_pos" => POSE_REPLY,
                b"servo_move" => SERVO_MODE_REPLY,
                b"is_in_servomove" if in_servo_mode => IN_SERVO_MODE_REPLY,
                b"is_in_servomove" => NOT_IN_SERVO_MODE_REPLY,
                _ => return Err(io::Error::other("a request without a printed answer")),
            });
            start += len + 1;
        }
        buffer.copy_within(start..end, 0);
        end -= start;
        stream.write_all(&out)?;
        out.clear();
    }
}
