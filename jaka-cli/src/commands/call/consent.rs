//! Confirmation before a request is sent to the robot.

use jaka_spec::{Command, Effect, Role, words};
use serde_json::Value;

use super::options::Options;
use super::reply;
use super::request::Request;
use crate::arm::consent;
use crate::builtin;
use crate::failure::Failure;
use crate::target::packs::Protocol;
use crate::target::seat;
use crate::terminal::output;

/// Asks whether the user wants to send the request to the robot of this title, if necessary.
///
/// # Errors
/// The user declines, or there is no terminal.
pub(super) fn obtain(
    protocol: &Protocol,
    request: &Request<'_>,
    options: &Options,
    title: &str,
) -> Result<(), Failure> {
    if options.yes || options.robot.is_simulated() {
        return Ok(());
    }
    if is_harmless(protocol, request) {
        // A stop is not delayed by a warning.
        if !stops(protocol, request) {
            seat::warn(&options.robot);
        }
        return Ok(());
    }
    if options.raw {
        let name = &request.name;
        return Err(Failure::Usage(format!(
            "`{name}` was not sent: the effect of a command sent with --raw is not known; use --yes if you know it"
        )));
    }
    if role(request) == Some(Role::Stop) {
        output::note("a pack in the config file is confirmed: its stops are sent without a question");
    }
    let fields = request.command.map(|command| reply::of_request(&protocol.spec, command, &request.text));
    consent::obtain(request, &fields.unwrap_or_default(), title)
}

/// Whether a command is sent without a question: it only reads, concerns the connection alone, or stops the arm, since
/// a stop must not wait.
pub(super) fn is_harmless(protocol: &Protocol, request: &Request<'_>) -> bool {
    let effect = request.command.map(|command| command.effect);
    matches!(effect, Some(Effect::Query | Effect::Session)) || stops(protocol, request)
}

/// Warns at the start about stops of packs that need `--yes`, since nobody has confirmed their packs.
pub(super) fn warn_of_stops(protocol: &Protocol, options: &Options) {
    if protocol.is_confirmed || options.robot.is_simulated() {
        return;
    }
    let is_packs_stop = |command: &&Command| command.role == Some(Role::Stop) && !is_built_in(command);
    let stops: Vec<_> =
        protocol.spec.commands().filter(is_packs_stop).map(|command| format!("`{}`", command.wire)).collect();
    if !stops.is_empty() {
        let stops = words::list(&stops, "and");
        output::warning(&format!(
            "{stops} will not be sent: only a pack declares this as a stop, and the pack is not confirmed; name the pack in the config file, or use --yes"
        ));
    }
}

/// Whether the request is a stop or a pause of the built-in spec, or a stop of a pack that the user has confirmed. The
/// facts in a pack are its author's claim.
fn stops(protocol: &Protocol, request: &Request<'_>) -> bool {
    let Some(command) = request.command else { return false };
    match role(request) {
        Some(Role::Stop) => is_built_in(command) || protocol.is_confirmed,
        Some(Role::StopAxis | Role::Pause) => is_built_in(command),
        Some(Role::Resume | Role::SetPoint | Role::ServoMode | Role::Output | Role::State) | None => false,
    }
}

/// Whether this is a command of the built-in spec with a request unchanged by packs.
fn is_built_in(command: &Command) -> bool {
    builtin::spec().command(&command.wire).is_some_and(|known| known.request == command.request)
}

/// Returns the role of the request, which may be that of its variant.
fn role(request: &Request<'_>) -> Option<Role> {
    let command = request.command?;
    let tag = || {
        let jaka_spec::Request::Choice(choice) = &command.request else { return None };
        serde_json::from_str::<Value>(&request.text).ok()?.get(&choice.tag)?.as_i64()
    };
    command.role_of_variant(tag())
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    fn protocol(pack: &str, is_confirmed: bool) -> Protocol {
        let pack = jaka_spec::load_pack(builtin::spec(), jaka_spec::Source { path: "pack.toml", text: pack });
        Protocol::new(pack.expect("it is correct").spec, Vec::new(), is_confirmed)
    }

    fn request<'s>(command: &'s Command, text: &str) -> Request<'s> {
        Request { command: Some(command), name: command.wire.clone(), text: text.to_owned() }
    }

    const HALT: &str = r#"
        title = "T"

        [[command]]
        wire = "demo_halt"
        effect = "motion"
        role = "stop"
        doc = "Stops."

        [[command.example]]
        request = '{"cmdName": "demo_halt"}'

        [[command]]
        wire = "demo_pause"
        effect = "motion"
        role = "pause"
        doc = "Pauses."

        [[command.example]]
        request = '{"cmdName": "demo_pause"}'
        "#;

    #[test]
    fn a_stop_of_a_pack_that_nobody_has_confirmed_is_asked_about() {
        for (is_confirmed, expected) in [(false, false), (true, true)] {
            let protocol = protocol(HALT, is_confirmed);
            let command = protocol.spec.command("demo_halt").expect("the pack has it");
            assert_eq!(is_harmless(&protocol, &request(command, r#"{"cmdName": "demo_halt"}"#)), expected);
        }
    }

    #[test]
    fn what_changes_something_is_asked_about_unless_it_stops() {
        let protocol = protocol(HALT, true);
        let spec = &protocol.spec;
        let mut at_once = Vec::new();
        for command in spec.commands().filter(|command| !matches!(command.effect, Effect::Query | Effect::Session)) {
            for example in command.examples.iter().filter_map(|example| example.request.as_deref()) {
                at_once.extend(is_harmless(&protocol, &request(command, example)).then_some(example));
            }
        }
        expect![[r#"
            {"cmdName": "jog", "jog_mode": 0, "coord_map": 1, "jnum": 1}
            {"cmdName": "pause_program"}
            {"cmdName": "stop_program"}
            {"cmdName": "demo_halt"}"#]]
        .assert_eq(&at_once.join("\n"));
    }
}
