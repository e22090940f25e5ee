//! Asking before something happens to a robot.

use std::io::{IsTerminal, stdin};

use jaka_spec::words::first_sentence;
use jaka_spec::{Command, Effect, Spec};
use jaka_sync::proto;
use jaka_sync::proto::check::AdvisoryRanges;
use jaka_sync::proto::text::{visible, visible_json_line};
use jaka_sync::proto::wire::Writer;

use crate::failure::Failure;
use crate::question;

/// A request that is about to be sent.
#[derive(Debug)]
pub(crate) struct Intent<'s> {
    /// The command in the spec, if it is there.
    pub(crate) command: Option<&'s Command>,
    /// `cmdName`.
    pub(crate) name: String,
    /// What is sent, byte for byte.
    pub(crate) text: String,
}

impl<'s> Intent<'s> {
    /// The intent to send this.
    ///
    /// # Errors
    /// The spec forbids it.
    pub(crate) fn of<C: proto::Command>(spec: &'s Spec, request: &C) -> Result<Self, Failure> {
        request.check(AdvisoryRanges::Enforced).map_err(jaka_sync::Error::from)?;
        let mut out = Writer::new();
        request.write_request(&mut out);
        let name = C::INFO.name;
        Ok(Self { command: spec.command(name), name: name.to_owned(), text: out.into_string() })
    }

    fn effect(&self) -> &'static str {
        self.command.map_or("is not known", |command| effect(command.effect))
    }
}

/// Makes sure that the user wants all of this to be sent to the robot of this title.
///
/// # Errors
/// The user does not, or cannot be asked.
pub(crate) fn obtain(intents: &[Intent<'_>], title: &str) -> Result<(), Failure> {
    let names: Vec<_> = intents.iter().map(|intent| format!("`{}`", intent.name)).collect();
    let (names, it) = (names.join(" and "), if let [_] = intents { "it" } else { "them" });
    let was = if let [_] = intents { "was" } else { "were" };
    let refused = |why: &str| Failure::Usage(format!("{names} {was} not sent{why}"));
    if !stdin().is_terminal() {
        let what = if let [only] = intents { format!("it {}, and ", only.effect()) } else { String::new() };
        return Err(refused(&format!(": {what}there is no terminal to ask on; use --yes to send {it} anyway")));
    }
    if question::is_confirmed(&question(intents, title))? { Ok(()) } else { Err(refused("")) }
}

/// Makes sure that the user wants the arm of the robot of this title to do this.
///
/// # Errors
/// The user does not, or cannot be asked.
pub(crate) fn obtain_motion(what: &str, title: &str) -> Result<(), Failure> {
    let refused = |why: &str| Failure::Usage(format!("the arm was not moved{why}"));
    if !stdin().is_terminal() {
        return Err(refused(": there is no terminal to ask on; use --yes to move it anyway"));
    }
    let question = format!("The arm of {title} will {}.\n{SEAT}\nGo on? [y/N] ", visible(what));
    if question::is_confirmed(&question)? { Ok(()) } else { Err(refused("")) }
}

const SEAT: &str = "The command port serves one client: another program that is connected there may be disconnected.";

fn question(intents: &[Intent<'_>], title: &str) -> String {
    let sent = intents.iter().map(|intent| format!("  {}\n", visible_json_line(&intent.text)));
    let told = intents.iter().map(|intent| {
        let about = intent.command.map_or("", |command| first_sentence(&command.doc).0);
        format!("`{}` {}. {}\n", visible(&intent.name), intent.effect(), visible(about))
    });
    let it = if let [_] = intents { "it" } else { "them" };
    format!("To {title}:\n{}{}{SEAT}\nSend {it}? [y/N] ", sent.collect::<String>(), told.collect::<String>())
}

/// What a command does to the robot, in words.
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
    use jaka_sync::power::{EnableRobot, PowerOff, PowerOn};

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
        .assert_eq(&question(&[off], "cell1 (10.5.5.100)"));
        let up = [
            Intent::of(&spec, &PowerOn::new()).expect("it is allowed"),
            Intent::of(&spec, &EnableRobot::new()).expect("it is allowed"),
        ];
        expect![[r#"
            To cell1 (10.5.5.100):
              {"cmdName":"power_on"}
              {"cmdName":"enable_robot"}
            `power_on` switches power, brakes or the controller itself. Switches the arm's power on.
            `enable_robot` switches power, brakes or the controller itself. Enables the arm, so that it can move.
            The command port serves one client: another program that is connected there may be disconnected.
            Send them? [y/N] "#]]
        .assert_eq(&question(&up, "cell1 (10.5.5.100)"));
    }
}
