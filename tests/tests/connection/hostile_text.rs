//! Texts of a controller in errors of the library: on one line, without a character that a terminal obeys. The command
//! `jaka` has its own tests for this.

use std::error::Error as StdError;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::exchange::OutOfSync;
use jaka_proto::framing::Framer;
use jaka_proto::text::is_visible;
use jaka_proto::wire::DecodeError;
use jaka_proto::{ErrorCode, FirmwareVersion, Refusal};
use jaka_robot::jaka_sync::ErrorKind as Failure;
use jaka_robot::{Cause, Disconnect, Error, ErrorKind, Evidence, Occurrence, Recorder};
use jaka_sim::Fault;
use jaka_tests::Arm;

/// A character of each kind that a terminal or an editor acts on.
const HOSTILE: &str = "\u{1b}[2J\u{7}\r\n\u{85}\u{9b}31m\u{7f}\u{61c}\u{200e}\u{202e}\u{2066}\u{2028}\u{feff}";

fn assert_visible(what: &str, text: &str) {
    let hidden: Vec<_> = text.chars().filter(|&c| !is_visible(c)).collect();
    assert!(hidden.is_empty(), "{what}: {hidden:?} in {text:?}");
}

#[test]
fn no_error_shows_a_controller_s_text_raw() {
    let refusal = || Refusal::new(HOSTILE, ErrorCode(2), HOSTILE);
    let unfit = || DecodeError::unfit("a number", HOSTILE).in_field(HOSTILE);
    let mut framer = Framer::default();
    framer.push(HOSTILE.as_bytes());
    let garbage = framer.next_frame().map(drop).expect_err("it is not a frame");
    let causes = [
        Disconnect::Frame(garbage),
        Disconnect::NotJson(unfit()),
        Disconnect::OutOfSync(OutOfSync::Unsolicited { command: HOSTILE.into() }),
        Disconnect::Ended { by: HOSTILE.to_owned() },
    ]
    .map(Arc::new);
    let (command, source) = (HOSTILE.to_owned(), unfit());
    let connection = |failure: Failure| ErrorKind::Connection(failure.into());
    let mut kinds = vec![
        ErrorKind::Refused { refusal: refusal(), explanation: None },
        ErrorKind::Refused { refusal: refusal(), explanation: Some(Cause::NotPowered.into()) },
        connection(Failure::Refused { refusal: refusal() }),
        connection(Failure::Timeout { command: command.clone(), after: Duration::ZERO }),
        connection(Failure::ReplyLost { command: command.clone() }),
        connection(Failure::UnexpectedReply { command: command.clone(), source: source.clone() }),
        connection(Failure::UnexpectedStatus { source }),
    ];
    for cause in causes {
        let lost = Evidence::Status { cause: Some(Arc::clone(&cause)), unreadable: None };
        kinds.push(ErrorKind::NotAcknowledged { occurrence: Occurrence::new(Cause::StatusLost, lost) });
        kinds.push(connection(Failure::Disconnected {
            address: HOSTILE.to_owned(),
            command: Some(command.clone()),
            sent: true,
            cause: Arc::clone(&cause),
        }));
        let (address, what) = (HOSTILE.to_owned(), HOSTILE.to_owned());
        let lost = Evidence::Commands { address: address.clone(), cause: Arc::clone(&cause) };
        kinds.push(ErrorKind::NotAcknowledged { occurrence: Occurrence::new(Cause::CommandsLost, lost) });
        kinds.push(ErrorKind::CommandsLost { address, what, cause });
    }
    let event = Evidence::Event { code: HOSTILE.to_owned(), event: None, message: HOSTILE.to_owned() };
    let occurrence = Occurrence::new(Cause::ControllerError, event);
    assert_visible("an occurrence", &occurrence.to_string());
    kinds.push(ErrorKind::NotAcknowledged { occurrence });
    let errors: Vec<Error> = kinds.into_iter().map(Error::from).collect();
    for error in &errors {
        let sources = std::iter::successors(Some(error as &dyn StdError), |&error| error.source());
        sources.for_each(|part| assert_visible(&format!("{error:?}"), &part.to_string()));
    }
    let version = HOSTILE.parse::<FirmwareVersion>().expect_err("it is none");
    assert_visible("a version", &version.to_string());
}

#[test]
fn the_text_itself_is_kept_as_it_came() {
    let recorder = Recorder::new(std::io::sink()).expect("a thread can be had");
    let (controller, mut client) = Arm::simulated().config(|config| config.recorder(recorder)).with_client();
    let message = serde_json::Value::from(HOSTILE);
    let reply = format!(r#"{{"errorCode":"7","errorMsg":{message},"cmdName":"get_version"}}"#);
    controller.inject(Fault::Instead(reply.into_bytes()));
    let error = client.get_version().expect_err("it is refused");
    assert_eq!(error.refusal().map(|refusal| &*refusal.message), Some(HOSTILE));
    for line in format!("{error:#}").lines() {
        assert_visible("the last messages", line);
    }
    controller.set_state(|state| state.error_message = HOSTILE.to_owned());
    assert_eq!(controller.stream().next_packet().expect("a packet comes").error_message.as_deref(), Some(HOSTILE));
}
