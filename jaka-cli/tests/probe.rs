//! `jaka probe`, as its users run it: `src/tests/probe.rs` has what it reports.

use std::fs;
use std::io::Write;
use std::net::TcpListener;
use std::path::PathBuf;
use std::thread;

use expect_test::expect;
use jaka_sim::Firmware;
use jaka_spec::{Source, load_pack};
use jaka_tests::{Arm, ReservedPort, spec};
use serde_json::{Value, json};

use crate::program::{Run, address_of, jaka, pack, scratch};

fn arm() -> Arm {
    Arm::real_time().without_power().controller(|controller| controller.firmware(Firmware::Document)).start()
}

fn probe(arm: &Arm) -> Run {
    jaka(["probe", "--yes"].map(str::to_owned).into_iter().chain(address_of(arm)))
}

/// A file that does not exist yet.
fn unwritten(name: &str) -> PathBuf {
    let path = scratch(name);
    fs::remove_file(&path).ok();
    path
}

/// The draft of a probe that reads this packet as often as is said.
fn draft_of_packets(name: &str, count: usize, edit: impl FnOnce(&mut Value)) -> String {
    let controller = arm();
    let mut stream = jaka_sync::StatusStream::connect_with(&controller.config(), controller.status_addr())
        .expect("the port is open");
    stream.next_packet().expect("a packet comes");
    let mut packet: Value = serde_json::from_str(stream.packet_text().expect("it is kept")).expect("packets are JSON");
    edit(&mut packet);
    let status = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let port = status.local_addr().expect("it is bound").port().to_string();
    let draft = unwritten(name);
    let commands = controller.command_addr().port().to_string();
    let packets = count.to_string();
    let run = thread::scope(|scope| {
        let sent = scope.spawn(move || {
            status.accept().and_then(|(mut reader, _)| reader.write_all(packet.to_string().repeat(count).as_bytes()))
        });
        let draft = draft.display().to_string();
        let run = jaka([
            "probe",
            "--yes",
            "--robot",
            "127.0.0.1",
            "--command-port",
            &commands,
            "--status-port",
            &port,
            "--draft",
            &draft,
            "--packets",
            &packets,
        ]);
        sent.join().expect("it does not panic").expect("the packet is sent");
        run
    });
    assert_eq!(run.code, Some(7), "{}", run.text());
    fs::read_to_string(&draft).expect("the draft is written")
}

#[test]
fn keys_of_the_status_packet_and_of_types_inside_it_are_drafted() {
    let text = draft_of_packets("status.toml", 1, |packet| {
        packet["brakeState"] = json!(1);
        packet["extio"]["watch dog"] = json!(true);
    });
    expect![[r#"
        # A draft by `jaka probe`: answer each TODO, and correct guessed names and types.
        title = "Messages of 1.6.5_01_X86 beyond the spec"

        [[extend]]
        target = "RobotStatus"

        [[extend.field]]
        wire = "brakeState"
        name = "brake_state"
        type = "int"
        optional = true
        doc = "TODO: its meaning is not known yet. 1.6.5_01_X86 sends 1."

        [[extend]]
        target = "ExtioReport"

        [[extend.field]]
        wire = "watch dog"
        name = "watch_dog"
        type = "bool"
        optional = true
        doc = "TODO: its meaning is not known yet. 1.6.5_01_X86 sends true."
    "#]]
    .assert_eq(&text);
    load_pack(&spec(), Source { path: "status.toml", text: &text }).expect("the draft loads");
}

#[test]
fn a_key_of_the_status_packet_that_took_the_place_of_another_is_proposed_as_its_new_name() {
    let text = draft_of_packets("renamed_status.toml", 1, |packet| {
        let packet = packet.as_object_mut().expect("packets are objects");
        let value = packet.remove("inpos").expect("it is sent");
        packet.insert("in_pos".to_owned(), value);
    });
    expect![[r#"
        # A draft by `jaka probe`: answer each TODO, and correct guessed names and types.
        title = "Messages of 1.6.5_01_X86 beyond the spec"

        # TODO: check this proposal. status packet: `inpos` is missing, and `in_pos` is new and looks like it: true
        [[override]]
        target = "RobotStatus"
        field = "inpos"
        wire = "in_pos"
    "#]]
    .assert_eq(&text);
    load_pack(&spec(), Source { path: "renamed_status.toml", text: &text }).expect("the draft loads");
}

#[test]
fn packets_are_samples_of_a_list() {
    for (packets, expected) in [(1, "float[]"), (2, "float[3]")] {
        let text = draft_of_packets("packets.toml", packets, |packet| packet["demo_list"] = json!([1, 2, 3]));
        assert!(text.contains(&format!("\ntype = \"{expected}\"\n")), "{text}");
    }
}

#[test]
fn what_a_pack_adds_is_probed_too() {
    let run = jaka(["probe", "--sim", "--pack", &pack("newer.toml")]);
    assert_eq!(run.code, Some(0), "{}", run.text());
    assert!(run.out.lines().any(|line| line.starts_with("demo_motion_state ") && line.ends_with(" ok")), "{}", run.out);
    assert!(!run.out.contains("demo_set_period"), "{}", run.out);
}

#[test]
fn without_a_controller_there_is_nothing_to_report() {
    let nobody = ReservedPort::any();
    let port = nobody.address().port().to_string();
    let run = jaka(["probe", "--yes", "--robot", "127.0.0.1", "--command-port", &port, "--status-port", &port]);
    assert_eq!((run.code, run.out.as_str()), (Some(3), ""));
}

#[test]
fn the_probe_takes_over_the_command_port() {
    let controller = arm();
    let mut client = controller.client();
    client.get_version().expect("it is answered");
    assert_eq!(probe(&controller).code, Some(0));
    assert!(client.get_version().expect_err("another client has taken its place").is_disconnected());
}
