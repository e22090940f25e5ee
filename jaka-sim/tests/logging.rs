//! Log messages. Alone in its process, since a process has one logger.

mod common;

use std::sync::Mutex;

use common::{Peer, fresh, request};

static LINES: Mutex<Vec<String>> = Mutex::new(Vec::new());

struct Lines;

impl log::Log for Lines {
    fn enabled(&self, _: &log::Metadata<'_>) -> bool {
        true
    }

    fn log(&self, record: &log::Record<'_>) {
        let line = format!("{} {}: {}", record.level(), record.target(), record.args());
        LINES.lock().expect("no test panics here").push(line);
    }

    fn flush(&self) {}
}

#[test]
fn the_wire_is_logged_at_trace_level() {
    log::set_logger(&Lines).expect("it is the only one");
    log::set_max_level(log::LevelFilter::Trace);
    let controller = fresh();
    let mut peer = Peer::commands(&controller);
    peer.call("power_on");
    peer.send("?");
    peer.receive();
    drop(controller);
    let lines = LINES.lock().expect("no test panics here");
    let expected = [
        "TRACE jaka_sim: command client connected".to_owned(),
        format!("TRACE jaka_sim: received {}", request("power_on")),
        r#"TRACE jaka_sim: sends {"errorCode":"0","errorMsg":"","cmdName":"power_on","power status":"True"}"#
            .to_owned(),
        "TRACE jaka_sim: received garbage".to_owned(),
        r#"TRACE jaka_sim: sends {"errorCode":"1","errorMsg":"Exception:function call failed"}"#.to_owned(),
        "TRACE jaka_sim: command client leaves".to_owned(),
    ];
    assert_eq!(*lines, expected);
}
