//! Wire logging through the `log` facade.

use std::sync::Mutex;
use std::time::Duration;

use jaka_sim::Fault;
use jaka_sync::collision::ClearError;
use jaka_tests::Arm;
use log::{LevelFilter, Log, Metadata, Record};

/// Keeps the lines of the client's target.
struct Kept(Mutex<Vec<String>>);

impl Log for Kept {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        metadata.target() == "jaka_sync::wire"
    }

    fn log(&self, record: &Record<'_>) {
        if self.enabled(record.metadata()) {
            let line = format!("{} {}", record.level(), record.args());
            self.0.lock().expect("no test panics while it logs").push(line);
        }
    }

    fn flush(&self) {}
}

static KEPT: Kept = Kept(Mutex::new(Vec::new()));

#[test]
fn each_message_is_logged_and_each_late_reply() {
    log::set_logger(&KEPT).expect("this is the only test of the process");
    log::set_max_level(LevelFilter::Trace);
    let (controller, mut client) = Arm::simulated().with_client();
    controller.inject(Fault::Hold);
    assert!(client.call_within(&ClearError::new(), Duration::from_millis(50)).is_err_and(|error| error.is_timeout()));
    client.set_rapid_rate(0.5).expect("it answers");
    let kept = KEPT.0.lock().expect("no test panics while it logs");
    assert_eq!(
        *kept,
        [
            r#"TRACE -> {"cmdName":"clear_error"}"#,
            r#"TRACE -> {"cmdName":"rapid_rate","rate_value":0.5}"#,
            r#"TRACE <- {"errorCode": "0", "errorMsg": "", "cmdName": "clear_error"}"#,
            "DEBUG late reply to `clear_error` dropped",
            r#"TRACE <- {"errorCode": "0", "errorMsg": "", "cmdName": "rapid_rate"}"#,
        ]
    );
}
