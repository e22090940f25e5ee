//! A client in another language that knows nothing of this code talks to `jaka sim` on both ports.

use std::process::{Child, Command};

use jaka_tests::skipped;

use crate::common::{jaka, started};

/// Python's standard library alone: sockets and JSON.
const CLIENT: &str = r#"
import json, socket, sys

def objects(connection):
    decoder, text = json.JSONDecoder(), ""
    while True:
        try:
            value, end = decoder.raw_decode(text.lstrip())
            text = text.lstrip()[end:]
            yield value
        except ValueError:
            chunk = connection.recv(65536)
            if not chunk:
                return
            text += chunk.decode()

commands, status = int(sys.argv[1]), int(sys.argv[2])
robot = socket.create_connection(("127.0.0.1", commands), timeout=30)
replies = objects(robot)

def call(name, **fields):
    robot.sendall(json.dumps({"cmdName": name, **fields}).encode())
    reply = next(replies)
    assert reply["cmdName"] == name, reply
    return reply

assert call("joint_move", relFlag=1, jointPosition=[1, 0, 0, 0, 0, 0], speed=10)["errorCode"] == "2"
assert call("power_on")["errorCode"] == "0"
assert call("enable_robot")["errorCode"] == "0"
start = call("get_joint_pos")["joint_pos"]
assert call("joint_move", relFlag=1, jointPosition=[5, 0, 0, 0, 0, 0], speed=50, accel=200)["errorCode"] == "0"
packets = objects(socket.create_connection(("127.0.0.1", status), timeout=30))
for packet in packets:
    assert packet["powered_on"] == 1 and packet["enabled"] is True
    if abs(packet["joint_actual_position"][0] - start[0] - 5) < 1e-6 and packet["inpos"]:
        break
robot.sendall(b'{"cmdName": "no_such_command"}')
assert next(replies) == {"errorCode": "1", "errorMsg": "Exception:function call failed"}
print("done")
"#;

/// The program, ended with the test.
struct Program(Child);

impl Drop for Program {
    fn drop(&mut self) {
        // It may have ended already.
        self.0.kill().ok();
        self.0.wait().ok();
    }
}

fn has_python() -> bool {
    Command::new("python3").arg("--version").output().is_ok_and(|output| output.status.success())
}

#[test]
fn a_python_client_drives_the_simulator() {
    if !has_python() {
        skipped("a client in Python", "there is no python3 here");
        return;
    }
    let (program, _out, line) = started(&mut jaka(&["sim", "--fast", "--commands", "0", "--status", "0"]));
    let _program = Program(program);
    let ports: Vec<_> = line.trim_end().split(", ").filter_map(|part| part.rsplit(':').next()).collect();
    assert_eq!(ports.len(), 2, "{line}");
    let client = Command::new("python3").arg("-c").arg(CLIENT).args(&ports).output().expect("python3 runs");
    assert!(client.status.success(), "{}", String::from_utf8_lossy(&client.stderr));
    assert_eq!(String::from_utf8_lossy(&client.stdout).trim(), "done");
}
