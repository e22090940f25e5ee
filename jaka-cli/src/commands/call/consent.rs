//! Asking before something happens to the robot.

use std::io::{IsTerminal, stdin};

use jaka_spec::Effect;
use jaka_spec::words::first_sentence;
use jaka_sync::motion::Jog;
use jaka_sync::proto;
use jaka_sync::proto::text::{visible, visible_json_line};

use super::help;
use super::options::Options;
use super::request::Request;
use crate::failure::Failure;
use crate::question;

/// Makes sure that the user wants the request to be sent to the robot of this title.
///
/// # Errors
/// The user does not, or cannot be asked.
pub(super) fn obtain(request: &Request<'_>, options: &Options, title: &str) -> Result<(), Failure> {
    if options.yes || options.robot.is_simulated() || is_harmless(request) {
        return Ok(());
    }
    if options.raw {
        return Err(Failure::Usage(format!(
            "`{}` was not sent: its effect is not known when it is sent unchecked; use --yes if you know it",
            request.name
        )));
    }
    if !stdin().is_terminal() {
        return Err(Failure::Usage(format!(
            "`{}` was not sent: it {}, and there is no terminal to ask on; use --yes to send it anyway",
            request.name,
            effect(request)
        )));
    }
    if question::is_confirmed(&question(request, title))? {
        return Ok(());
    }
    Err(Failure::Usage(format!("`{}` was not sent", request.name)))
}

/// True for commands that are sent without a question: those that only read, that concern the connection alone, or that stop the arm,
/// since a stop must not wait.
fn is_harmless(request: &Request<'_>) -> bool {
    let effect = request.command.map(|command| command.effect);
    matches!(effect, Some(Effect::Query | Effect::Session)) || request.command.is_some() && stops(&request.text)
}

fn stops(request: &str) -> bool {
    use proto::Request::{Jog as JogRequest, PauseProgram, StopProgram};
    matches!(proto::Request::read(request), Ok(StopProgram(_) | PauseProgram(_) | JogRequest(Jog::Stop { .. })))
}

fn effect(request: &Request<'_>) -> &'static str {
    request.command.map_or("is not known", |command| help::effect(command.effect))
}

fn question(request: &Request<'_>, title: &str) -> String {
    let about = request.command.map_or("", |command| first_sentence(&command.doc).0);
    let (sent, name) = (visible_json_line(&request.text), visible(&request.name));
    format!("To {title}:\n  {sent}\n`{name}` {}. {}\nSend it? [y/N] ", effect(request), visible(about))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use jaka_spec::{Command, Spec};

    use super::*;

    fn spec() -> Spec {
        jaka_spec::builtin().expect("the spec's own tests load it")
    }

    fn request<'s>(command: &'s Command, text: &str) -> Request<'s> {
        Request { command: Some(command), name: command.wire.clone(), text: text.to_owned() }
    }

    #[test]
    fn what_changes_something_is_asked_about_unless_it_stops() {
        let spec = spec();
        let mut at_once = Vec::new();
        for command in spec.commands().filter(|command| !matches!(command.effect, Effect::Query | Effect::Session)) {
            for example in command.examples.iter().filter_map(|example| example.request.as_deref()) {
                at_once.extend(is_harmless(&request(command, example)).then_some(example));
            }
        }
        expect![[r#"
            {"cmdName": "jog", "jog_mode": 0, "coord_map": 1, "jnum": 1}
            {"cmdName": "pause_program"}
            {"cmdName": "stop_program"}"#]]
        .assert_eq(&at_once.join("\n"));
    }

    #[test]
    fn the_question_says_what_will_happen() {
        let spec = spec();
        let command = spec.command("power_off").expect("the protocol has it");
        let asked = question(&request(command, "{\"cmdName\":\"power_off\"}"), "cell1 (10.5.5.100)");
        expect![[r#"
            To cell1 (10.5.5.100):
              {"cmdName":"power_off"}
            `power_off` switches power, brakes or the controller itself. Switches the arm's power off.
            Send it? [y/N] "#]]
        .assert_eq(&asked);
    }
}
