//! A controller of plain sockets, whose arm is where the test says: it computes poses by the witness, and keeps each
//! request as it came.

use std::io::{ErrorKind, Read, Write};
use std::net::{Ipv4Addr, SocketAddr, SocketAddrV4, TcpListener};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use jaka_sim::SimulatedClock;
use serde_json::{Deserializer, Value, json};

use crate::witness::way::{Bounds, inverted};
use crate::witness::{Frame, angles, inverse, pose, product};

/// A controller of plain sockets, for one client and one reader.
#[derive(Debug, Clone)]
pub struct PlainController {
    /// Address of its command port.
    pub commands: SocketAddr,
    /// Address of its status port.
    pub status: SocketAddr,
    state: Arc<Mutex<State>>,
    /// None where time is real.
    clock: Option<SimulatedClock>,
}

#[derive(Debug)]
struct State {
    bounds: Bounds,
    joints: [f64; 6],
    servo_mode: bool,
    /// The requests that move the arm, and when they came.
    motions: Vec<(Instant, Value)>,
}

/// Time between two packets.
const PERIOD: Duration = Duration::from_millis(20);

/// A free port of loopback.
const LOOPBACK: SocketAddr = SocketAddr::V4(SocketAddrV4::new(Ipv4Addr::LOCALHOST, 0));

/// A connection.
trait Stream: Read + Write {}

impl<S: Read + Write> Stream for S {}

const MOTIONS: [&str; 6] = ["joint_move", "end_move", "moveL", "movc", "servo_j", "servo_p"];

impl PlainController {
    /// A controller that ends with the connections to it. Time is real.
    ///
    /// # Panics
    /// Loopback has no free ports.
    pub fn start(bounds: Bounds, joints: [f64; 6]) -> Self {
        Self::listening(None, bounds, joints)
    }

    /// A controller in simulated time, which stands still until a client and a reader have connected.
    ///
    /// # Panics
    /// Loopback has no free ports.
    pub fn by_clock(clock: &SimulatedClock, bounds: Bounds, joints: [f64; 6]) -> Self {
        Self::listening(Some(clock.clone()), bounds, joints)
    }

    fn listening(clock: Option<SimulatedClock>, bounds: Bounds, joints: [f64; 6]) -> Self {
        let state = State { bounds, joints, servo_mode: false, motions: Vec::new() };
        let mut controller = Self { commands: LOOPBACK, status: LOOPBACK, state: Arc::new(Mutex::new(state)), clock };
        controller.commands = controller.serve(|controller, stream| controller.answer(stream));
        controller.status = controller.serve(|controller, stream| controller.publish(stream));
        controller
    }

    /// Serves the one that connects, in a thread of its own; returns where it listens.
    fn serve(&self, serve: fn(&Self, &mut dyn Stream)) -> SocketAddr {
        let controller = self.clone();
        let Some(clock) = &self.clock else {
            let listener = TcpListener::bind(LOOPBACK).expect("loopback has free ports");
            let address = listener.local_addr().expect("it is bound");
            thread::spawn(move || {
                let (mut stream, _) = listener.accept().expect("it listens");
                stream.set_nodelay(true).expect("it is connected");
                serve(&controller, &mut stream);
            });
            return address;
        };
        let listener = clock.bind(LOOPBACK).expect("loopback has free ports");
        let (address, place) = (listener.local_addr(), clock.servant());
        thread::spawn(move || place.run(|| serve(&controller, &mut listener.accept().expect("it listens"))));
        address
    }

    /// The arm is there from now on.
    pub fn put(&self, joints: [f64; 6]) {
        self.lock().joints = joints;
    }

    /// The requests that move the arm, since this was last asked for.
    pub fn motions(&self) -> Vec<Value> {
        self.timed_motions().into_iter().map(|(_, request)| request).collect()
    }

    /// The requests that move the arm since the last call, each with the time of its arrival.
    pub fn timed_motions(&self) -> Vec<(Instant, Value)> {
        std::mem::take(&mut self.lock().motions)
    }

    /// Joint position of the arm, in degrees.
    pub fn joints(&self) -> [f64; 6] {
        self.lock().joints
    }

    /// Packets of an arm that is ready and at rest.
    fn publish(&self, stream: &mut dyn Stream) {
        loop {
            let packet = json!({
                "errcode": "0x0", "errmsg": "", "enabled": true, "paused": false, "powered_on": 1, "inpos": true,
                "emergency_stop": 0, "protective_stop": 0, "joint_actual_position": self.joints(),
            });
            if stream.write_all(packet.to_string().as_bytes()).is_err() {
                return;
            }
            match &self.clock {
                Some(clock) => clock.sleep(PERIOD),
                // Packets that come later change no test's result.
                None => thread::sleep(PERIOD),
            }
        }
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn answer(&self, stream: &mut dyn Stream) {
        let (mut text, mut bytes) = (Vec::new(), [0; 4096]);
        loop {
            let count = match stream.read(&mut bytes) {
                Ok(count @ 1..) => count,
                // In simulated time also if the client begins to take part after this has begun to read.
                Err(error) if matches!(error.kind(), ErrorKind::Interrupted | ErrorKind::WouldBlock) => continue,
                _ => break,
            };
            text.extend_from_slice(&bytes[..count]);
            let mut requests = Deserializer::from_slice(&text).into_iter::<Value>();
            let mut replies = String::new();
            while let Some(Ok(request)) = requests.next() {
                let now = self.clock.as_ref().map_or_else(Instant::now, SimulatedClock::now);
                replies.push_str(&self.lock().reply(request, now).to_string());
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
    fn reply(&mut self, request: Value, now: Instant) -> Value {
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
                self.motions.push((now, request));
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

/// Six numbers of a message.
///
/// # Panics
/// They are something else.
pub fn six(value: &Value) -> [f64; 6] {
    std::array::from_fn(|index| value[index].as_f64().expect("six numbers"))
}
