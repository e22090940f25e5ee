//! A controller of plain sockets, whose arm is where the test says: it computes poses by the witness, and keeps each request as it came.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use jaka_tests::witness::way::{Bounds, inverted};
use jaka_tests::witness::{Frame, angles, inverse, pose, product};
use serde_json::{Deserializer, Value, json};

#[derive(Clone)]
pub(crate) struct PlainController {
    pub(crate) commands: SocketAddr,
    pub(crate) status: SocketAddr,
    state: Arc<Mutex<State>>,
}

struct State {
    bounds: Bounds,
    joints: [f64; 6],
    servo_mode: bool,
    /// The requests that move the arm, and when they came.
    motions: Vec<(Instant, Value)>,
}

const MOTIONS: [&str; 6] = ["joint_move", "end_move", "moveL", "movc", "servo_j", "servo_p"];

impl PlainController {
    /// Ends with the connections to it.
    pub(crate) fn start(bounds: Bounds, joints: [f64; 6]) -> Self {
        let listen = || TcpListener::bind(("127.0.0.1", 0)).expect("loopback has free ports");
        let (commands, status) = (listen(), listen());
        let address = |listener: &TcpListener| listener.local_addr().expect("it listens");
        let state = State { bounds, joints, servo_mode: false, motions: Vec::new() };
        let state = Arc::new(Mutex::new(state));
        let controller = Self { commands: address(&commands), status: address(&status), state };
        let answering = controller.clone();
        thread::spawn(move || commands.accept().map(|(stream, _)| answering.answer(stream)));
        let publishing = controller.clone();
        thread::spawn(move || status.accept().map(|(stream, _)| publishing.publish(stream)));
        controller
    }

    /// The arm is there from now on.
    pub(super) fn put(&self, joints: [f64; 6]) {
        self.lock().joints = joints;
    }

    /// The requests that move the arm, since this was last asked for.
    pub(super) fn motions(&self) -> Vec<Value> {
        self.timed_motions().into_iter().map(|(_, request)| request).collect()
    }

    /// The same, and when each came.
    pub(crate) fn timed_motions(&self) -> Vec<(Instant, Value)> {
        std::mem::take(&mut self.lock().motions)
    }

    /// Where the arm is.
    pub(super) fn joints(&self) -> [f64; 6] {
        self.lock().joints
    }

    /// Packets of an arm that is ready and at rest.
    fn publish(&self, mut stream: TcpStream) {
        loop {
            let packet = json!({
                "errcode": "0x0", "errmsg": "", "enabled": true, "paused": false, "powered_on": 1, "inpos": true,
                "emergency_stop": 0, "protective_stop": 0, "joint_actual_position": self.joints(),
            });
            if stream.write_all(packet.to_string().as_bytes()).is_err() {
                return;
            }
            thread::sleep(Duration::from_millis(20));
        }
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn answer(&self, mut stream: TcpStream) {
        let _ = stream.set_nodelay(true);
        let (mut text, mut bytes) = (Vec::new(), [0; 4096]);
        while let Ok(count @ 1..) = stream.read(&mut bytes) {
            text.extend_from_slice(&bytes[..count]);
            let mut requests = Deserializer::from_slice(&text).into_iter::<Value>();
            let mut replies = String::new();
            while let Some(Ok(request)) = requests.next() {
                replies.push_str(&self.lock().reply(request).to_string());
            }
            let done = requests.byte_offset();
            text.drain(..done);
            if stream.write_all(replies.as_bytes()).is_err() {
                break;
            }
        }
    }
}

impl State {
    fn reply(&mut self, request: Value) -> Value {
        let name = request["cmdName"].as_str().expect("each request has a name").to_owned();
        let mut reply = json!({"errorCode": "0", "errorMsg": "", "cmdName": name});
        match &*name {
            "kine_forward" => reply["cartPosition"] = json!(self.pose(six(&request["jointPosition"]))),
            "kine_inverse" => match self.inverse(&request) {
                Some(joints) => reply["jointPosition"] = json!(joints),
                None => reply["errorCode"] = json!("2"),
            },
            "get_joint_pos" => reply["joint_pos"] = json!(self.joints),
            "get_tcp_pos" => reply["tcp_pos"] = json!(self.pose(self.joints)),
            "servo_move" => self.servo_mode = request["relFlag"] == 1,
            "is_in_servomove" => reply["in_servomove"] = json!(self.servo_mode),
            _ if MOTIONS.contains(&&*name) => {
                self.follow(&name, &request);
                self.motions.push((Instant::now(), request));
            }
            _ => {}
        }
        reply
    }

    /// The arm is at each set-point at once.
    fn follow(&mut self, name: &str, request: &Value) {
        match (name, request["relFlag"] == 1) {
            ("servo_j", false) => self.joints = six(&request["jointPosition"]),
            ("servo_j", true) => {
                let offset = six(&request["jointPosition"]);
                self.joints = std::array::from_fn(|joint| self.joints[joint] + offset[joint]);
            }
            ("servo_p", false) => {
                let near = json!({"cartPosition": request["catPosition"], "jointPosition": self.joints});
                self.joints = self.inverse(&near).unwrap_or(self.joints);
            }
            _ => {}
        }
    }

    fn pose(&self, joints: [f64; 6]) -> [f64; 6] {
        let frame = product(self.bounds.base, self.bounds.tcp(joints));
        let [rx, ry, rz] = angles(frame);
        [frame[0][3], frame[1][3], frame[2][3], rx, ry, rz]
    }

    fn inverse(&self, request: &Value) -> Option<[f64; 6]> {
        let target = product(inverted(self.bounds.base), frame(six(&request["cartPosition"])));
        let flange = product(target, inverted(self.bounds.tool));
        inverse(&self.bounds.arm, flange, six(&request["jointPosition"]))
    }
}

fn frame([x, y, z, rx, ry, rz]: [f64; 6]) -> Frame {
    pose([x, y, z], [rx, ry, rz].map(f64::to_radians))
}

pub(crate) fn six(value: &Value) -> [f64; 6] {
    std::array::from_fn(|index| value[index].as_f64().expect("six numbers"))
}
