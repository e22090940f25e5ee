//! Asking before something happens to the robot.

use jaka_robot::motion::Jog;
use jaka_robot::proto;
use jaka_spec::{Effect, Spec};

use super::options::Options;
use super::reply;
use super::request::Request;
use crate::consent;
use crate::failure::Failure;
use crate::seat;

/// Makes sure that the user wants the request to be sent to the robot of this title.
///
/// # Errors
/// The user does not, or cannot be asked.
pub(super) fn obtain(spec: &Spec, request: &Request<'_>, options: &Options, title: &str) -> Result<(), Failure> {
    if options.yes || options.robot.is_simulated() {
        return Ok(());
    }
    if is_harmless(request) {
        // A stop does not wait for a terminal either.
        if !stops(&request.text) {
            seat::warn(&options.robot);
        }
        return Ok(());
    }
    if options.raw {
        let name = &request.name;
        return Err(Failure::Usage(format!(
            "`{name}` was not sent: its effect is not known when it is sent unchecked; use --yes if you know it"
        )));
    }
    let fields = request.command.map(|command| reply::of_request(spec, command, &request.text)).unwrap_or_default();
    consent::obtain(request, &fields, title)
}

/// True for commands that are sent without a question: those that only read, that concern the connection alone, or that stop the arm,
/// since a stop must not wait.
pub(super) fn is_harmless(request: &Request<'_>) -> bool {
    let effect = request.command.map(|command| command.effect);
    matches!(effect, Some(Effect::Query | Effect::Session)) || request.command.is_some() && stops(&request.text)
}

fn stops(request: &str) -> bool {
    use proto::Request::{Jog as JogRequest, PauseProgram, StopProgram};
    matches!(proto::Request::read(request), Ok(StopProgram(_) | PauseProgram(_) | JogRequest(Jog::Stop { .. })))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use jaka_spec::Command;

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
}
