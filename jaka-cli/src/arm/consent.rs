//! Confirmation before an action on a robot.

use std::io::{IsTerminal, stdin};
use std::slice::from_ref;

use itertools::Itertools as _;
use jaka_robot::proto;
use jaka_robot::proto::check::{AdvisoryRanges, InvalidArgument, NotSent};
use jaka_robot::proto::text::{visible, visible_json_line};
use jaka_robot::proto::wire::Writer;
use jaka_spec::words::first_sentence;
use jaka_spec::{Command, Effect, Spec};

use crate::arm::units::other_unit;
use crate::failure::Failure;
use crate::target::seat::ONE_CLIENT;
use crate::terminal::question;

/// Request that is about to be sent.
#[derive(Debug)]
pub(crate) struct Intent<'s> {
    /// Command in the spec, if the spec has it.
    pub(crate) command: Option<&'s Command>,
    /// `cmdName`.
    pub(crate) name: String,
    /// Text to send, byte for byte.
    pub(crate) text: String,
}

impl<'s> Intent<'s> {
    /// Returns the intent to send this request.
    ///
    /// # Errors
    /// The spec forbids the request.
    pub(crate) fn of<C: proto::Command>(spec: &'s Spec, request: &C) -> Result<Self, Failure> {
        match request.check(AdvisoryRanges::Enforced) {
            Ok(()) => {}
            Err(NotSent::InvalidArgument(invalid)) => return Err(not_allowed(&invalid)),
            Err(forbidden @ NotSent::NotInFirmware(_)) => return Err(jaka_sync::Error::from(forbidden).into()),
        }
        let mut out = Writer::new();
        request.write_request(&mut out);
        let name = C::INFO.name;
        Ok(Self { command: spec.command(name), name: name.to_owned(), text: out.into_string() })
    }

    /// Returns the text to send, as a line of a question.
    fn line(&self) -> String {
        format!("  {}\n", visible_json_line(&self.text))
    }

    /// Returns the effect on the robot, in words.
    pub(crate) fn effect(&self) -> &'static str {
        self.command.map_or("is not known", |command| effect(command.effect))
    }
}

/// Checks that there is a terminal for a question about these requests.
///
/// # Errors
/// There is no terminal.
pub(crate) fn must_be_askable(intents: &[Intent<'_>]) -> Result<(), Failure> {
    if stdin().is_terminal() {
        return Ok(());
    }
    let (what, do_it) = match intents {
        [] => (String::new(), "move it"),
        [only] => (format!("it {}, and ", only.effect()), "send it"),
        _ => (String::new(), "send them"),
    };
    Err(not_done(intents, &format!(": {what}there is no terminal to ask on; use --yes to {do_it} anyway")))
}

/// Asks whether the user wants to send this request, whose effect only the spec describes, to the robot of this title.
/// The question has the fields as a table.
///
/// # Errors
/// The user declines, or there is no terminal.
pub(crate) fn obtain(intent: &Intent<'_>, fields: &str, title: &str) -> Result<(), Failure> {
    let intents = from_ref(intent);
    must_be_askable(intents)?;
    if question::is_confirmed(&question(intent, fields, title))? { Ok(()) } else { Err(not_done(intents, "")) }
}

/// Asks whether the user wants this of the arm of the robot of this title, such as "turn joint 6 by 5 deg", for which
/// these requests, or set-points, are sent.
///
/// # Errors
/// The user declines, or there is no terminal.
pub(crate) fn obtain_act(what: &str, intents: &[Intent<'_>], title: &str) -> Result<(), Failure> {
    must_be_askable(intents)?;
    if question::is_confirmed(&act_question(what, intents, title))? { Ok(()) } else { Err(not_done(intents, "")) }
}

/// Creates the failure without a hint at the option for advisory ranges, which only `jaka call` has.
fn not_allowed(invalid: &InvalidArgument) -> Failure {
    let InvalidArgument { command, field, value, allowed, .. } = invalid;
    let hint = value.parse().ok().and_then(|value| other_unit(value, allowed)).unwrap_or_default();
    Failure::Usage(format!("`{command}` was not sent: field `{field}` is {value}, allowed is {allowed}{hint}"))
}

fn not_done(intents: &[Intent<'_>], why: &str) -> Failure {
    let names = intents.iter().map(|intent| format!("`{}`", intent.name)).join(" and ");
    Failure::Usage(match intents {
        [] => format!("the arm was not moved{why}"),
        [_] => format!("{names} was not sent{why}"),
        _ => format!("{names} were not sent{why}"),
    })
}

fn act_question(what: &str, intents: &[Intent<'_>], title: &str) -> String {
    let sent: String = intents.iter().map(Intent::line).collect();
    format!("The arm of {title} will {}.\n{sent}{ONE_CLIENT}\nGo on? [y/N] ", visible(what))
}

fn question(intent: &Intent<'_>, fields: &str, title: &str) -> String {
    let fields: String = fields.lines().map(|line| ["  ", line, "\n"].concat()).collect();
    let about = intent.command.map_or("", |command| first_sentence(&command.doc).0);
    let (sent, name, effect) = (intent.line(), visible(&intent.name), intent.effect());
    format!("To {title}:\n{sent}`{name}` {effect}. {}\n{fields}{ONE_CLIENT}\nSend it? [y/N] ", visible(about))
}

/// Returns the effect of a command on the robot, in words.
pub(crate) fn effect(effect: Effect) -> &'static str {
    match effect {
        Effect::Query => "reads, changes nothing",
        Effect::Setting => "changes a setting or an output",
        Effect::Motion => "starts, stops or continues a motion or a program",
        Effect::Power => "switches power, brakes or the controller itself",
        Effect::Session => "concerns the connection alone",
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use jaka_robot::power::{EnableRobot, PowerOff, PowerOn};

    use super::*;

    #[test]
    fn the_question_says_what_will_happen() {
        let spec = jaka_spec::builtin().expect("the spec's own tests load it");
        let off = Intent::of(&spec, &PowerOff::new()).expect("it is allowed");
        expect![[r#"
            To cell1 (10.5.5.100):
              {"cmdName":"power_off"}
            `power_off` switches power, brakes or the controller itself. Switches the arm's power off.
            The command port serves one client: another program that is connected there may be disconnected.
            Send it? [y/N] "#]]
        .assert_eq(&question(&off, "", "cell1 (10.5.5.100)"));
        let up = [
            Intent::of(&spec, &PowerOn::new()).expect("it is allowed"),
            Intent::of(&spec, &EnableRobot::new()).expect("it is allowed"),
        ];
        expect![[r#"
            The arm of cell1 (10.5.5.100) will get power.
              {"cmdName":"power_on"}
              {"cmdName":"enable_robot"}
            The command port serves one client: another program that is connected there may be disconnected.
            Go on? [y/N] "#]]
        .assert_eq(&act_question("get power", &up, "cell1 (10.5.5.100)"));
    }
}
