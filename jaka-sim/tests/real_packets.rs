//! Packets and replies byte by byte, against what captures of real controllers show.
//!
//! The tables here were written from those captures: a packet of a Zu 5 with firmware 1.5.14, and 311 packets of a
//! newer controller. They share nothing with the simulator's own.

use crate::common::{Peer, request};
use jaka_proto::messages::io::ExtioSetup;
use jaka_sim::{Controller, Delays, Firmware, State};

/// The keys that stand for `STATE` in both tables.
const STATE: &str = "
    task_state int
    homed [9 int]
    task_mode int
    interp_state int
    enabled bool
    paused bool
    rapidrate float
    current_tool_id int
    current_user_id int
    on_soft_limit int
    emergency_stop int
    drag_near_limit [6 int]
    funcdi [15 [2 int]]
    powered_on int
    inpos bool
    motion_mode int
    curr_tcp_trans_vel float
    protective_stop int
    point_key int
";

/// The keys of firmware 1.5.14 in order, each with the shape of its value: `[135 int]` is an array of 135 whole
/// numbers.
const V1_5_14: &str = "
    len int
    drag_status bool
    errcode text
    errmsg text
    monitor_data [2 int, 3 float, [6 [11 float]]]
    torqsensor [[int, [text, int], [float, [3 float]]], [2 int, 2 [6 float]]]
    joint_actual_position [6 float]
    actual_position [6 float]
    din [135 int]
    dout [135 int]
    ain [64 float]
    aout [64 float]
    tio_din [8 int]
    tio_dout [8 int]
    tio_ain [2 float]
    STATE
    netState int
";

/// Keys and shapes of the newer controller's packets; its module has 10, 10, 8 and 8 pins.
const NEWER: &str = "
    len int
    drag_status bool
    extio {status [2 [10 int], 2 [8 float]], setup [[int, text, [text, 2 int], [4 [2 int]], text]], num int, pinmap [[4 int]], mode int}
    errcode text
    errmsg text
    monitor_data [2 int, 3 float, [6 [11 float]], 3 int, float]
    torqsensor [[int, [text, int], [float, [3 float]]], [2 int, 3 [6 float]]]
    instVel [6 float]
    joint_actual_position [6 float]
    joint_position [6 float]
    actual_position [6 float]
    position [6 float]
    din [199 int]
    dout [199 int]
    ain [128 float]
    aout [128 float]
    tio_key [3 int]
    tio_din [8 int]
    tio_dout [8 int]
    tio_ain [2 float]
    relay_io [2 int]
    mb_slave_din [128 int]
    mb_slave_dout [128 int]
    mb_slave_ain [64 float]
    mb_slave_aout [64 float]
    pn_dev_din [64 int]
    pn_dev_dout [64 int]
    pn_dev_ain [64 float]
    pn_dev_aout [64 float]
    eip_adpt_din [64 int]
    eip_adpt_dout [64 int]
    eip_adpt_ain [48 float]
    eip_adpt_aout [48 float]
    STATE
    motion_line int
    err_add_line int
    tio_rs_signals [8 [text, 4 int, float]]
    netState int
";

/// Rest of a message whose parts are separated as controllers separate them.
struct Spaced<'m>(&'m str);

impl<'m> Spaced<'m> {
    fn take(&mut self, text: &str) -> bool {
        let rest = self.0.strip_prefix(text);
        self.0 = rest.unwrap_or(self.0);
        rest.is_some()
    }

    fn expect(&mut self, text: &str) {
        assert!(self.take(text), "`{text}` is missing before `{:.40}`", self.0);
    }

    /// A string without its quotes. None here has an escape.
    fn string(&mut self) -> &'m str {
        self.expect("\"");
        let (string, rest) = self.0.split_once('"').expect("the string ends");
        assert!(!string.contains('\\'), "{string}");
        self.0 = rest;
        string
    }

    /// The members of an object: key, text and shape of each.
    fn members(&mut self) -> Vec<(&'m str, &'m str, String)> {
        let mut members = Vec::new();
        self.expect("{");
        while !self.take("}") {
            if !members.is_empty() {
                self.expect(", ");
            }
            let key = self.string();
            self.expect(": ");
            let before = self.0;
            let shape = self.shape();
            members.push((key, &before[..before.len() - self.0.len()], shape));
        }
        members
    }

    /// The shape of the next value.
    fn shape(&mut self) -> String {
        if self.0.starts_with('"') {
            self.string();
            return "text".to_owned();
        }
        if self.0.starts_with('{') {
            let members: Vec<_> = self.members().into_iter().map(|(key, _, shape)| format!("{key} {shape}")).collect();
            return format!("{{{}}}", members.join(", "));
        }
        if self.take("[") {
            return self.elements();
        }
        let end = self.0.find([',', ']', '}']).expect("the message ends");
        let (scalar, rest) = self.0.split_at(end);
        self.0 = rest;
        let digits = scalar.strip_prefix('-').unwrap_or(scalar);
        let is_number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        match digits.split_once('.') {
            _ if scalar == "true" || scalar == "false" => "bool",
            Some((whole, fraction)) if is_number(whole) && is_number(fraction) => "float",
            None if is_number(digits) => "int",
            _ => panic!("`{scalar}` is neither a truth value nor a number as controllers write them"),
        }
        .to_owned()
    }

    /// The shape of an array: what follows itself is counted.
    fn elements(&mut self) -> String {
        let mut runs: Vec<(usize, String)> = Vec::new();
        while !self.take("]") {
            if !runs.is_empty() {
                self.expect(", ");
            }
            let shape = self.shape();
            match runs.last_mut() {
                Some((count, last)) if *last == shape => *count += 1,
                _ => runs.push((1, shape)),
            }
        }
        let runs = runs.into_iter().map(|(count, shape)| if count == 1 { shape } else { format!("{count} {shape}") });
        format!("[{}]", runs.collect::<Vec<_>>().join(", "))
    }
}

/// The members of a message, of which nothing is left.
fn members(message: &str) -> Vec<(&str, &str, String)> {
    let mut rest = Spaced(message);
    let members = rest.members();
    assert_eq!(rest.0, "");
    members
}

fn text_of<'m>(message: &'m str, key: &str) -> &'m str {
    let found = members(message).into_iter().find(|(name, ..)| *name == key);
    found.unwrap_or_else(|| panic!("`{key}` is missing in {message}")).1
}

fn controller(firmware: Firmware) -> Controller {
    let builder = Controller::builder().delays(Delays::NONE).stepped_clock();
    builder.firmware(firmware).start().expect("loopback has ports")
}

/// Gives the extension module as many pins as that of the newer controller has.
fn give_pins(state: &mut State) {
    let Some(ExtioSetup::Tcp { pins, .. }) = state.extio.modules.first_mut().map(|module| &mut module.setup) else {
        panic!("the module is connected by TCP");
    };
    (pins.digital_inputs.count, pins.digital_outputs.count) = (10, 10);
    (pins.analog_inputs.count, pins.analog_outputs.count) = (8, 8);
}

#[test]
fn packets_have_the_keys_lengths_and_number_formats_of_captures() {
    for (firmware, table, sizes) in [(Firmware::V1_5_14, V1_5_14, 3170..=3240), (Firmware::Newer, NEWER, 8820..=9100)] {
        let controller = controller(firmware);
        // As many digits as the arm of the first capture has: its packet has 3208 bytes, and those of the second 8955
        // to 8979, with a torque sensor whose readings are not 0.0.
        controller.set_state(|state| {
            state.joint_position = [-63.40236, 106.90883, 75.54514, 89.82753, -93.42602, -13.40708].into();
            give_pins(state);
        });
        let packet = Peer::status(&controller).receive();
        let found = members(&packet).into_iter().map(|(key, _, shape)| format!("{key} {shape}"));
        let table = table.replace("STATE", STATE);
        let expected: Vec<_> = table.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
        assert_eq!(found.collect::<Vec<_>>(), expected, "{firmware}");
        assert_eq!(text_of(&packet, "len"), packet.len().to_string());
        assert!(sizes.contains(&packet.len()), "{firmware}: {}", packet.len());
    }
}

#[test]
fn what_stands_still_is_what_captures_show() {
    for firmware in [Firmware::V1_5_14, Firmware::Newer] {
        let packet = Peer::status(&controller(firmware)).receive();
        let expected = [
            ("drag_status", "false"),
            ("errcode", "\"0x0\""),
            ("errmsg", "\"\""),
            ("homed", "[1, 1, 1, 1, 1, 1, 0, 0, 0]"),
            ("on_soft_limit", "0"),
            ("rapidrate", "1.0"),
            ("inpos", "true"),
            ("motion_mode", "1"),
            ("netState", "1"),
        ];
        for (key, text) in expected {
            assert_eq!(text_of(&packet, key), text, "{firmware}: {key}");
        }
    }
    let packet = Peer::status(&controller(Firmware::V1_5_14)).receive();
    assert_eq!(text_of(&packet, "tio_ain"), "[474.0, 474.0]");
    let packet = Peer::status(&controller(Firmware::Newer)).receive();
    let monitor = text_of(&packet, "monitor_data");
    assert!(monitor.starts_with("[12338, 12593, ") && monitor.ends_with("]], 0, 0, 0, 23.39]"), "{monitor}");
    let signal = r#"["", 0, 0, 0, 0, 0.0]"#;
    assert_eq!(text_of(&packet, "tio_rs_signals"), format!("[{}]", [signal; 8].join(", ")));
    let setup = text_of(&packet, "extio");
    assert!(setup.contains("\", 8888, 1], [[") && setup.contains("]], \"ext_"), "{setup}");
}

#[test]
fn joints_have_five_decimals_in_packets_and_six_in_replies() {
    for firmware in [Firmware::V1_5_14, Firmware::Newer] {
        let controller = controller(firmware);
        controller.set_state(|state| {
            state.joint_position = [-26.340_510_7, 106.25, 75.061_059_3, 89.0, -93.426_702_4, -1e-9].into();
        });
        let packet = Peer::status(&controller).receive();
        let joints = "[-26.34051, 106.25, 75.06106, 89.0, -93.4267, -0.0]";
        assert_eq!(text_of(&packet, "joint_actual_position"), joints, "{firmware}");
        let mut peer = Peer::commands(&controller);
        peer.send(request("get_joint_pos"));
        let joints = "[-26.340511, 106.25, 75.061059, 89.0, -93.426702, -0.0]";
        assert_eq!(text_of(&peer.receive(), "joint_pos"), joints, "{firmware}");
    }
}

/// Reads packets as the vendor's SDK 2.1.9 does: one begins with `{"len": ` and has as many bytes as stand there.
/// `None` where it would wait for ever.
fn read_as_sdk_2_1_9(stream: &str) -> Option<Vec<&str>> {
    let mut rest = stream;
    let mut packets = Vec::new();
    while !rest.is_empty() {
        let (length, _) = rest.strip_prefix("{\"len\": ")?.split_once(", ")?;
        let (packet, after) = rest.split_at_checked(length.parse().ok()?)?;
        packets.push(packet);
        rest = after;
    }
    Some(packets)
}

#[test]
fn the_vendors_sdk_2_1_9_reads_the_packets_of_real_firmware() {
    let three = |firmware| {
        let controller = controller(firmware);
        let mut reader = Peer::status(&controller);
        let mut packets = vec![reader.receive()];
        for position in [0.5, -1.0 / 3.0] {
            controller.set_state(|state| state.joint_position.0[0] = position);
            controller.publish();
            packets.push(reader.receive());
        }
        packets
    };
    for firmware in [Firmware::default(), Firmware::V1_5_14, Firmware::Newer] {
        let packets = three(firmware);
        let read = read_as_sdk_2_1_9(&packets.concat()).map(|read| read.into_iter().map(str::to_owned).collect());
        assert_eq!(read, Some(packets), "{firmware}");
    }
    // It hangs on the document's text.
    assert_eq!(read_as_sdk_2_1_9(&three(Firmware::Document).concat()), None);
}

#[test]
fn the_vendors_sdk_2_1_14_finds_a_number_in_the_robots_state() {
    let controller = controller(Firmware::Newer);
    let mut peer = Peer::commands(&controller);
    let mut ask = |command: &str| {
        peer.send(request(command));
        peer.receive()
    };
    // It aborts on a string.
    assert_eq!(text_of(&ask("get_robot_state"), "errcode"), "0");
    for (command, code) in [("power_on", 0), ("enable_robot", 17_760_260), ("disable_robot", 17_760_261)] {
        ask(command);
        assert_eq!(text_of(&ask("get_robot_state"), "errcode"), code.to_string(), "{command}");
    }
    assert_eq!(text_of(&ask("get_robot_state"), "msg"), "\"the robot is disabled\"");
}

/// The reply of 1.5.14 was recorded twice, with the document's words and no further keys; one of the newer controller
/// has `"True"` for both states.
#[test]
fn the_robots_state_has_the_words_of_the_firmware() {
    let state = |firmware| {
        let controller = controller(firmware);
        let mut peer = Peer::commands(&controller);
        let mut ask = |command: &str| {
            peer.send(request(command));
            peer.receive()
        };
        ask("power_on");
        ask("enable_robot");
        ask("get_robot_state")
    };
    let old = state(Firmware::V1_5_14);
    let mut keys: Vec<_> = members(&old).into_iter().map(|(key, ..)| key.to_owned()).collect();
    keys.sort_unstable();
    assert_eq!(keys, ["cmdName", "enable", "errorCode", "errorMsg", "power"]);
    assert_eq!((text_of(&old, "enable"), text_of(&old, "power")), ("\"robot_enabled\"", "\"powered_on\""));
    let newer = state(Firmware::Newer);
    assert_eq!((text_of(&newer, "enable"), text_of(&newer, "power")), ("\"True\"", "\"True\""));
}

/// 311 packets of the newer controller have 13 to 17 digits in poses, no function with an input, and `task_state` 3 is
/// what five clients have of a disabled arm.
#[test]
fn the_newer_packet_has_long_poses_no_function_inputs_and_the_clients_task_state() {
    let controller = controller(Firmware::Newer);
    let mut peer = Peer::commands(&controller);
    peer.send(request("power_on"));
    peer.receive();
    controller.set_state(|state| {
        state.joint_position = [-63.402_361_7, 106.908_83, 75.545_14, 89.827_53, -93.426_02, -13.407_08].into();
    });
    let packet = Peer::status(&controller).receive();
    let digits = |text: &str| text.bytes().filter(u8::is_ascii_digit).count();
    let pose = text_of(&packet, "actual_position");
    assert!(pose.split(", ").all(|number| (10..=18).contains(&digits(number))), "{pose}");
    let joints = text_of(&packet, "joint_actual_position");
    assert!(joints.starts_with("[-63.40236, 106.90883, "), "{joints}");
    assert_eq!(text_of(&packet, "funcdi"), format!("[{}]", ["[-1, -1]"; 15].join(", ")));
    assert_eq!(text_of(&packet, "task_state"), "3");
}

#[test]
fn replies_have_the_words_and_the_version_of_the_firmware() {
    let expected = [
        (Firmware::V1_5_14, "\"robot_disabled\"", "\"powered_off\"", "\"1.5.14_13_X64\""),
        (Firmware::Newer, "\"False\"", "\"False\"", "\"1.7.2\""),
    ];
    for (firmware, enable, power, version) in expected {
        let controller = controller(firmware);
        let mut peer = Peer::commands(&controller);
        peer.send(request("get_robot_state"));
        let reply = peer.receive();
        assert_eq!((text_of(&reply, "enable"), text_of(&reply, "power")), (enable, power), "{firmware}");
        peer.send(request("get_version"));
        assert_eq!(text_of(&peer.receive(), "version"), version, "{firmware}");
        peer.send(request("fly"));
        assert_eq!(peer.receive(), r#"{"errorCode": "1", "errorMsg": "Exception:function call failed"}"#);
    }
}
