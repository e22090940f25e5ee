//! Seeds of fuzzing: real messages and files, for each target.

use std::time::Duration;

use jaka_sim::{Controller, Firmware};
use jaka_sync::StatusStream;

use crate::{printed, spec};

/// The inputs from which libFuzzer makes up others, for the target of this name; none for a name that no target has.
///
/// # Panics
/// A file or message of the project is damaged.
pub fn seeds(target: &str) -> Vec<Vec<u8>> {
    let texts = match target {
        "fault_plan" => fault_plans(),
        "framing" => streams(),
        "json" => messages().chain(typed()).collect(),
        "pack" => packs(),
        "python" => literals(),
        "recording" => recordings(),
        "replies" => replies(),
        "requests" => requests(),
        "simulator" => sessions(),
        "spec_file" => spec_files(),
        "status" => packets(),
        _ => Vec::new(),
    };
    texts.into_iter().map(String::into_bytes).collect()
}

fn messages() -> impl Iterator<Item = String> {
    printed().into_iter().map(|message| message.text)
}

fn requests() -> Vec<String> {
    printed().into_iter().filter(|message| message.is_request).map(|message| message.text).collect()
}

/// Also those forms that the document does not print.
fn replies() -> Vec<String> {
    let others = [
        "(0, [], {'state': 0})",
        r#"{"errorCode": "1", "errorMsg": "Exception:function call failed"}"#,
        r#"{"errorCode":"-1","errorMsg":"servoj command can only be excuted in servo move mode","cmdName":"servo_j"}"#,
        r#"{"errorCode":"0","enabled status":"True","cmdName":"enable_robot"}"#,
        r#"{"errorCode": "0x2", "errorMsg": null, "cmdName": " jog ", "new": {"deep": [1, {"er": null}]}}"#,
        r#"{"enable": "robot_enabled", "power": 1, "errorCode": 0, "cmdName": "get_robot_state"}"#,
    ];
    let of_document = printed().into_iter().filter(|message| !message.is_request).map(|message| message.text);
    of_document.chain(others.map(str::to_owned)).collect()
}

/// Messages in a row, some with garbage in between, after the two bytes that say how they are cut.
fn streams() -> Vec<String> {
    let replies = replies();
    let with_cut = |(index, group): (usize, &[String])| {
        let gap = ["", "\r\n", " ", "x", "\0}"][index % 5];
        let cut = char::from(u8::try_from(index * 7 % 128).expect("it is small"));
        format!("\x0b{cut}{}", group.join(gap))
    };
    replies.chunks(4).enumerate().map(with_cut).collect()
}

/// An argument of a command with what could be typed for it, a line each.
fn typed() -> Vec<String> {
    let spec = spec();
    let of_command = |command: &jaka_spec::Command| {
        let lines = jaka_dynamic::arguments(&spec, command).into_iter().map(|argument| {
            let value = argument.values.first().map_or(argument.hint.clone(), |value| value.name.clone());
            format!("{}\n{}\n{}", command.wire, argument.name, value.replace("NUMBER", "1.5"))
        });
        lines.collect::<Vec<_>>()
    };
    spec.commands().flat_map(of_command).collect()
}

fn packets() -> Vec<String> {
    let packet = |firmware: &Firmware| {
        let builder = Controller::builder().firmware(*firmware).status_period(Duration::MAX);
        let controller = builder.start().expect("loopback has free ports");
        let mut status = StatusStream::connect(controller.status_addr()).expect("the controller listens");
        status.next_packet().expect("a packet comes on connecting");
        status.packet_text().expect("it is kept").to_owned()
    };
    let partial = [r#"{"torqsensor": [[0,0,0],[1]], "homed": [0, 1, 1]}"#, r#"{"len": 2, "homed": "?"}"#];
    Firmware::ALL.iter().map(packet).chain(partial.map(str::to_owned)).collect()
}

/// Replies as literals, and the other forms that Python has.
fn literals() -> Vec<String> {
    let others = [
        "(0, [], {'state': 0})",
        "( 1 , )",
        "{'a': (True, False, None,), u'b' : -2.5e3}",
        "('it\\'s', \"say \\\"so\\\"\", '\\x41\\n\\u00e9', '\\xe6\\x9c\\xba')",
        "(.5, 5., +1, 10L)",
    ];
    let of_document = messages().map(|json| jaka_proto::python::from_json(&json).expect("the document prints JSON"));
    of_document.chain(others.map(str::to_owned)).chain(messages().take(4)).collect()
}

fn recordings() -> Vec<String> {
    let file = concat!(
        r#"{"jaka_recording":1,"started":1763726000.123456,"software":"jaka-sync 0.1.0"}"#,
        "\n",
        r#"{"time":0.000412,"port":"command","connection":1,"event":"connected","address":"10.5.5.100:10001"}"#,
        "\n",
        r#"{"time":0.000593,"port":"command","connection":1,"event":"sent","text":"{\"cmdName\":\"power_on\"}"}"#,
        "\n",
        r#"{"time":0.001,"port":"command","event":"sent","text":"{\"cmdName\":\"get_extio_status\"}"}"#,
        "\n",
        r#"{"time":0.002,"port":"command","event":"received","text":"{\"errorCode\":\"0\",\"cmdName\":\"power_on\"}"}"#,
        "\n",
        r#"{"time":0.002190,"port":"command","connection":1,"event":"received","text":"(0, [])"}"#,
        "\n",
        r#"{"time":3,"port":"status","connection":2,"event":"received","hex":"7bff7d"}"#,
        "\n",
        r#"{"time":4,"port":"status","connection":2,"event":"dropped","count":7}"#,
        "\n",
        r#"{"time":4.5,"port":"command","event":"closed","by":"controller","why":"gone"}"#,
        "\n",
        r#"{"time":5,"port":"command","connection":3,"event":"error","text":"refused"}"#,
        "\n",
    );
    let lines: Vec<_> = file.lines().collect();
    let pairs = lines[1..].windows(2).map(|pair| [&lines[..1], pair].concat().join("\n"));
    pairs.chain([file.to_owned()]).collect()
}

/// Each fault alone, and a whole plan.
fn fault_plans() -> Vec<String> {
    let lines = [
        "none, drop, nameless, twice, close, reset, hold",
        "delay 200ms, close after 7, split 1 5",
        "for joint_move: hold, nameless",
        "random 7 1/20 drop, reset",
        "always twice",
        "status slow 2s",
        r#"instead "(0, [])\r\n\x00""#,
        "garbage 16 3; takeover # and no more",
    ];
    lines.iter().map(|line| (*line).to_owned()).chain([lines.join("\n")]).collect()
}

/// Each request on an arm that is enabled, and all of them in a row.
fn sessions() -> Vec<String> {
    let enabled = "{\"cmdName\":\"power_on\"}\n\n\n\n{\"cmdName\":\"enable_robot\"}\n\n\n";
    let requests = requests();
    let alone = requests.iter().map(|request| format!("{enabled}{request}\n\n"));
    let groups = requests.chunks(12).map(|group| format!("{enabled}{}\n", group.join("\n")));
    alone.chain(groups).collect()
}

/// The commands, types and error codes of the built-in spec, each as a file of its own, and the files that are short.
fn spec_files() -> Vec<String> {
    let files = jaka_spec::BUILTIN.iter().map(|source| source.text);
    let short = files.clone().filter(|text| text.len() < 4000).map(str::to_owned);
    files.flat_map(blocks).chain(short).collect()
}

/// The entries of a file, each after a title.
fn blocks(text: &str) -> Vec<String> {
    let starts = ["\n[[command]]", "\n[[type]]", "\n[[error]]", "\n[[extend]]", "\n[[override]]"];
    let mut places: Vec<_> = starts.iter().flat_map(|start| text.match_indices(start)).map(|(at, _)| at).collect();
    places.sort_unstable();
    places.push(text.len());
    places.windows(2).map(|pair| format!("title = \"T\"\n{}", &text[pair[0]..pair[1]])).collect()
}

fn packs() -> Vec<String> {
    let files = [
        include_str!("../data/fan.toml"),
        include_str!("../pack-user/changed.toml"),
        include_str!("../pack-user/newer.toml"),
        include_str!("../tests/offline/dynamic/pack.toml"),
    ];
    let readme = include_str!("../../spec/README.md");
    let of_readme = readme.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next());
    let whole = files.into_iter().chain(of_readme);
    whole.flat_map(|text| [blocks(text), vec![text.to_owned()]].concat()).collect()
}
