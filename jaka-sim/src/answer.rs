//! Answers of the controller to requests.
//!
//! `topics` has the state changes and the reply of each command. A command without a handler gets the spec's example,
//! so a new command in the spec has an answer without code.

mod motion;
mod pack;
mod remembered;
mod servo;
mod topics;
mod trajectory;

use jaka_proto::check::AdvisoryRanges;
use jaka_proto::messages::types::Switch;
use jaka_proto::wire::Writer;
use jaka_proto::{Command, ErrorCode, Request, RequestError, Visit, write_refusal, write_reply};
use jaka_spec::Effect;

pub(crate) use self::pack::put;
use crate::spec_index::{CommandEntry, SpecIndex, own_payload, usual_refusal};
use crate::world::{Change, Wait, World};

/// Outcome of a request in its topic.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    /// The handler has written the reply.
    Replied,
    /// The controller accepts the request, and sets nothing in its reply.
    Accepted,
    /// The controller cannot carry out the request.
    Refused,
    /// The topic does not handle the request, or the sample is sufficient as a reply.
    Unhandled,
}

/// Effect of a request beyond its immediate reply.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sequel {
    Nothing,
    /// The reply waits.
    Wait(Wait),
    /// The connection ends with the reply.
    SessionEnd,
    /// The connections of both ports end with the reply.
    Shutdown,
}

/// Draft of the reply to an accepted request.
struct Draft<'r> {
    /// Valid reply with the fields that a command's handler does not set.
    sample: &'r str,
    out: &'r mut Writer,
}

impl Outcome {
    fn accepted_if(accepted: bool) -> Self {
        if accepted { Self::Accepted } else { Self::Refused }
    }
}

/// Carries out a request, and writes the reply.
pub(crate) fn answer(text: &str, spec_index: &SpecIndex, world: &mut World, out: &mut Writer) -> Sequel {
    let own = spec_index.as_built_in(text);
    let request = Request::read(own.as_deref().unwrap_or(text));
    let command = match &request {
        Ok(request) => request.info().name,
        Err(RequestError::Unknown { command } | RequestError::Field { command, .. }) => command,
        Err(_) => "",
    };
    let known = spec_index.entry(command).filter(|entry| entry.is_in_firmware(&world.state.version));
    let Some(entry) = known else {
        refuse_unknown(spec_index, out);
        return Sequel::Nothing;
    };
    if let Some(message) = &entry.not_followed {
        refuse(command, &(ErrorCode::CALL_FAILED, message.clone()), out);
        return Sequel::Nothing;
    }
    if let Err(field) = &own {
        refuse(command, &(ErrorCode::CALL_FAILED, format!("call {command} failed: `{field}`")), out);
        return Sequel::Nothing;
    }
    // Refuses these commands even if a pack allows them: a request that cannot be read cannot be carried out.
    let is_of_pack = entry.packed && matches!(request, Err(RequestError::Unknown { .. }));
    if request.is_err() && !is_of_pack {
        refuse(command, &usual_refusal(command), out);
        return Sequel::Nothing;
    }
    let request = request.ok();
    carry_out((text, own.as_deref().unwrap_or(text)), request.as_ref(), (entry, spec_index), world, out);
    sequel(request.as_ref(), entry, world)
}

/// Returns the sequel of a request. The controller never refuses a command with a sequel.
fn sequel(request: Option<&Request>, entry: &CommandEntry, world: &World) -> Sequel {
    match (request, world.habits.late_queries) {
        (Some(Request::WaitComplete(_)), _) => after(Wait::Rest(None), world),
        (Some(Request::PowerOn(_)), _) if world.habits.late_power => after(Wait::Change(Change::PoweredOn), world),
        (Some(Request::EnableRobot(_)), _) if world.habits.late_power => after(Wait::Change(Change::Enabled), world),
        (Some(Request::Quit(_)), _) => Sequel::SessionEnd,
        (Some(Request::Shutdown(_)), _) => Sequel::Shutdown,
        // With the habit, replies to queries wait while the arm moves.
        (_, Some(time)) if entry.command.effect == Effect::Query => {
            after(Wait::Rest(world.now().checked_add(time)), world)
        }
        _ => Sequel::Nothing,
    }
}

/// Makes the reply follow the wait; it follows at once if the wait is over.
fn after(wait: Wait, world: &World) -> Sequel {
    if world.is_over(wait) { Sequel::Nothing } else { Sequel::Wait(wait) }
}

/// Writes the reply to an unknown request.
pub(crate) fn refuse_unknown(spec_index: &SpecIndex, out: &mut Writer) {
    write_refusal(None, ErrorCode::EXCEPTION, &spec_index.unknown, out);
}

/// Carries out a command, with its request as received and in terms of the built-in spec. `request` is `None` for a
/// command that only a pack has.
fn carry_out(
    (text, own): (&str, &str),
    request: Option<&Request>,
    (entry, spec_index): (&CommandEntry, &SpecIndex),
    world: &mut World,
    out: &mut Writer,
) {
    let CommandEntry { command, packed, .. } = entry;
    if let Some(refusal) = refusal(entry, world) {
        return refuse(&command.wire, &refusal, out);
    }
    let is_allowed = match request {
        Some(request) if !packed => request.check(AdvisoryRanges::Ignored).is_ok(),
        _ => pack::allows(&spec_index.spec, command, text),
    };
    let typed_sample = remembered::with(spec_index, command, &entry.typed_sample, &world.state);
    let mut draft = Draft { sample: &typed_sample, out };
    let outcome = match request {
        _ if !is_allowed => Outcome::Refused,
        Some(request) => match topics::answer(request, world, &mut draft) {
            Outcome::Accepted => request.visit(Accept(&mut draft)),
            Outcome::Unhandled if command.remembers.is_some() => request.visit(Accept(&mut draft)),
            outcome => outcome,
        },
        None => Outcome::Unhandled,
    };
    if outcome != Outcome::Refused {
        remembered::note(spec_index, command, own, &mut world.state);
    }
    match outcome {
        Outcome::Replied if *packed => {
            if !pack::complete(spec_index, command, out) {
                refuse(&command.wire, &usual_refusal(&command.wire), out);
            }
        }
        Outcome::Replied | Outcome::Accepted => {}
        Outcome::Refused => refuse(&command.wire, &usual_refusal(&command.wire), out),
        Outcome::Unhandled => out.raw(&remembered::with(spec_index, command, &entry.sample, &world.state)),
    }
    world.make_consistent();
}

/// Returns the refusal of a command that the present state excludes.
fn refusal(entry: &CommandEntry, world: &World) -> Option<(ErrorCode, String)> {
    if !entry.command.requires.iter().all(|requirement| world.state.meets(*requirement)) {
        return Some(entry.refusal.clone());
    }
    (entry.moves && !world.state.can_move()).then(|| usual_refusal(&entry.command.wire))
}

fn refuse(command: &str, (code, message): &(ErrorCode, String), out: &mut Writer) {
    write_refusal(Some(command), *code, message, out);
}

/// Accepts a command, with the reply fields set by the handler; the other fields are those of the sample.
fn reply<C: Command>(_command: &C, draft: &mut Draft<'_>, set: impl FnOnce(&mut C::Reply)) -> Outcome {
    let Ok(mut reply) = own_payload::<C::Reply>(draft.sample) else { return Outcome::Unhandled };
    set(&mut reply);
    write_reply(C::INFO, &reply, draft.out);
    Outcome::Replied
}

/// Writes the sample as the reply.
struct Accept<'d, 'r>(&'d mut Draft<'r>);

impl Visit for Accept<'_, '_> {
    type Output = Outcome;

    fn visit<C: Command>(self, command: &C) -> Outcome {
        reply(command, self.0, |_| {})
    }
}

/// Whether the switch is on; values other than on and off have been refused before.
fn is_on(switch: Switch) -> bool {
    switch == Switch::On
}
