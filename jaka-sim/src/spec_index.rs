//! Index of the spec's commands, by name.

use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};
use std::io;
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use jaka_dynamic::{Message, Translation, firmware_range};
use jaka_proto::messages::status::{ExtioReport, RobotStatus};
use jaka_proto::wire::{Decode, DecodeError, Fields, Reader, Writer};
use jaka_proto::{Command, Envelope, ErrorCode, FirmwareRange, Request, write_refusal};
use jaka_spec::{COMMAND_NAME, Effect, Field, Requirement, Source, Spec};
use serde_json::{Map, Value};

/// Spec, indexed by `cmdName`.
#[derive(Debug)]
pub(crate) struct SpecIndex {
    entries: HashMap<String, CommandEntry>,
    /// Whole spec.
    pub(crate) spec: Spec,
    /// Index of the built-in spec, if packs were added to it.
    base: Option<Arc<Self>>,
    /// Report on extension I/O modules by the built-in spec, to fill in.
    pub(crate) extio_report: Option<ExtioReport>,
    /// Message of the controller for an unknown command.
    pub(crate) unknown: String,
}

/// Entry of one command of the spec.
#[derive(Debug)]
pub(crate) struct CommandEntry {
    /// Command in the spec.
    pub(crate) command: jaka_spec::Command,
    /// Whether the command moves the arm and needs it enabled.
    pub(crate) moves: bool,
    /// Whether a pack adds or changes the command.
    pub(crate) packed: bool,
    /// Firmware with the command, if a pack limits it or the document does not have the command.
    beyond: Option<FirmwareRange>,
    /// Refusal message for a command changed by a pack in a way that the simulated arm cannot follow.
    pub(crate) not_followed: Option<String>,
    /// Code and message of the refusal in a wrong state.
    pub(crate) refusal: (ErrorCode, String),
    /// First successful reply printed in the spec; a generated one if there is none or a pack changes it.
    pub(crate) sample: String,
    /// Sample reply by the built-in spec, if that has the command.
    pub(crate) typed_sample: String,
}

impl SpecIndex {
    /// Returns the index of the built-in spec, which is read once in a process.
    fn built_in() -> io::Result<Arc<Self>> {
        static BUILT_IN: OnceLock<Arc<SpecIndex>> = OnceLock::new();
        if let Some(index) = BUILT_IN.get() {
            return Ok(Arc::clone(index));
        }
        let spec = jaka_spec::builtin().map_err(io::Error::other)?;
        Ok(Arc::clone(BUILT_IN.get_or_init(|| Arc::new(Self::new(spec, None, &BTreeSet::new())))))
    }

    /// Returns the index of the built-in spec with packs, each of which adds to the previous ones.
    pub(crate) fn open(packs: &[PathBuf]) -> io::Result<Arc<Self>> {
        let built_in = Self::built_in()?;
        if packs.is_empty() {
            return Ok(built_in);
        }
        let mut spec = built_in.spec.clone();
        let mut packed = BTreeSet::new();
        for path in packs {
            let name = path.display().to_string();
            let text = jaka_spec::read_text(path)
                .map_err(|error| io::Error::new(error.kind(), format!("cannot read the pack `{name}`: {error}")))?;
            let pack = jaka_spec::load_pack(&spec, Source { path: &name, text: &text })
                .map_err(|errors| io::Error::new(io::ErrorKind::InvalidData, errors))?;
            let changed: BTreeSet<_> =
                pack.module().topic.commands.iter().map(|command| command.wire.clone()).collect();
            check_status_followed(&built_in.spec, &pack.spec)
                .map_err(|why| io::Error::new(io::ErrorKind::Unsupported, format!("the pack `{name}`: {why}")))?;
            packed.extend(changed);
            spec = pack.spec;
        }
        Ok(Arc::new(Self::new(spec, Some(built_in), &packed)))
    }

    /// Creates the index of a spec that packs have derived from another one; `packed` has the commands that they add or
    /// change.
    fn new(spec: Spec, base: Option<Arc<Self>>, packed: &BTreeSet<String>) -> Self {
        let not_followed = |command: &str| {
            let base = base.as_ref().filter(|_| packed.contains(command))?;
            command_not_followed(&base.spec, &spec, command)
        };
        let entry = |command: &jaka_spec::Command| {
            let base = base.as_ref().and_then(|base| base.entry(&command.wire));
            let is_packed = packed.contains(&command.wire);
            CommandEntry::new(&spec, command, base, (is_packed, not_followed(&command.wire)))
        };
        let entries = spec.commands().map(|command| (command.wire.clone(), entry(command))).collect();
        let exception = spec.errors().find(|error| error.wire == ErrorCode::EXCEPTION.0);
        let unknown = exception.and_then(|error| error.message.clone()).unwrap_or_default();
        let extio_report = base.as_ref().map_or_else(|| extio_report(&spec), |base| base.extio_report.clone());
        Self { entries, spec, base, extio_report, unknown }
    }

    pub(crate) fn entry(&self, command: &str) -> Option<&CommandEntry> {
        self.entries.get(command)
    }

    /// Converts a request to the built-in spec, if a pack has other keys or forms for it.
    ///
    /// # Errors
    /// Name of a field with a value without a form there.
    pub(crate) fn as_built_in<'t>(&self, text: &'t str) -> Result<Cow<'t, str>, String> {
        let Some((name, members)) = self.of_packs(text) else { return Ok(Cow::Borrowed(text)) };
        let Some(base) = &self.base else { return Ok(Cow::Borrowed(text)) };
        let translated = Translation::new(&self.spec, &base.spec).message(Message::Request(&name), &members);
        match translated.lost.into_iter().next() {
            Some(name) => Err(name),
            None => Ok(Cow::Owned(Value::from(translated.members).to_string())),
        }
    }

    /// Returns the name and members of a request for a built-in command that packs change.
    fn of_packs(&self, text: &str) -> Option<(String, Map<String, Value>)> {
        let base = self.base.as_ref()?;
        let members: Map<_, _> = serde_json::from_str(text).ok()?;
        let name = members.get(COMMAND_NAME)?.as_str()?.trim().to_owned();
        base.entry(&name).and_then(|_| self.entry(&name)).filter(|entry| entry.packed)?;
        Some((name, members))
    }

    /// Returns the built-in spec, if packs were added to it.
    pub(crate) fn without_packs(&self) -> Option<&Spec> {
        self.base.as_ref().map(|base| &base.spec)
    }

    /// Returns the spec that defines the state for a command: the built-in one, if it has the command.
    pub(crate) fn spec_of(&self, command: &str) -> &Spec {
        let base = self.base.as_ref().filter(|base| base.entry(command).is_some());
        base.map_or(&self.spec, |base| &base.spec)
    }

    /// Converts a reply from the built-in spec to the keys and forms of packs; returns false if a value has none.
    pub(crate) fn with_packs(&self, command: &str, reply: &mut Map<String, Value>) -> bool {
        let Some(base) = self.base.as_ref().filter(|base| base.entry(command).is_some()) else { return true };
        let translated = Translation::new(&base.spec, &self.spec).message(Message::Reply(command), reply);
        *reply = translated.members;
        translated.lost.is_empty() && translated.unknown.is_empty()
    }

    /// Returns a value of the state for a key of status packets, which a pack may have changed, in JSON. `member`
    /// returns it for a key of the built-in spec. Returns `None` if the state has no value, and null if the value has
    /// no form there.
    pub(crate) fn status_value<'j>(&self, field: &Field, member: impl Fn(&str) -> Option<&'j str>) -> Option<String> {
        let Some(base) = &self.base else { return member(&field.wire).map(str::to_owned) };
        let (own, others) = (self.spec.status_fields(), base.spec.status_fields());
        let known = jaka_dynamic::counterpart(field, own, others)?;
        let json = member(&known.wire)?;
        let value: Value = serde_json::from_str(json).ok()?;
        let translated = Translation::new(&base.spec, &self.spec).field(known, field, &value).unwrap_or_default();
        // An unchanged value keeps its order of keys.
        Some(if translated == value { json.to_owned() } else { translated.to_string() })
    }

    /// Returns the reply that the spec prints for a command.
    pub(crate) fn example<C: Command>(&self) -> io::Result<C::Reply> {
        let entry = self.entry(C::INFO.name);
        let entry = entry.ok_or_else(|| io::Error::other(format!("the spec does not have `{}`", C::INFO.name)))?;
        own_payload(&entry.typed_sample).map_err(io::Error::other)
    }
}

impl CommandEntry {
    fn new(
        spec: &Spec,
        command: &jaka_spec::Command,
        base: Option<&Self>,
        (packed, not_followed): (bool, Option<String>),
    ) -> Self {
        let own = command.refusal.as_ref().map(|refusal| (ErrorCode(refusal.code), refusal.message.clone()));
        let mut replies = command.examples.iter().filter_map(|example| example.reply.as_deref());
        let printed = replies.find(|reply| is_success(reply) && !packed).map(str::to_owned);
        let sample = printed.unwrap_or_else(|| made_up(spec, command));
        let beyond = if packed && base.is_none() {
            Some(firmware_range(&command.versions))
        } else {
            let info = Request::COMMANDS.iter().find(|info| info.name == command.wire && info.section.is_empty());
            info.map(|info| info.firmware)
        };
        Self {
            moves: command.effect == Effect::Motion && command.requires.contains(&Requirement::Enabled),
            packed,
            not_followed,
            beyond,
            refusal: own.unwrap_or_else(|| usual_refusal(&command.wire)),
            typed_sample: base.map_or_else(|| sample.clone(), |base| base.typed_sample.clone()),
            sample,
            command: command.clone(),
        }
    }

    /// Whether firmware of this version has the command; firmware with an unreadable version has all commands.
    pub(crate) fn is_in_firmware(&self, version: &str) -> bool {
        self.beyond.is_none_or(|range| version.parse().map_or(true, |version| range.contains(version)))
    }
}

/// Returns an error if a pack changes the type or the meaning of a key of status packets: the state has no value for
/// it, and zeros would be false.
fn check_status_followed(built_in: &Spec, spec: &Spec) -> Result<(), String> {
    let lost = Translation::new(built_in, spec).lost(Message::Status);
    lost.first().map_or(Ok(()), |key| Err(format!("{}, in status packets", not_followed(key))))
}

/// Returns the refusal message for a command with a key whose type or meaning a pack changes; `None` if there is none.
fn command_not_followed(built_in: &Spec, spec: &Spec, command: &str) -> Option<String> {
    built_in.command(command)?;
    let missing = Translation::new(spec, built_in).missing(Message::Request(command));
    let lost = Translation::new(built_in, spec).lost(Message::Reply(command));
    missing.into_iter().chain(lost).next().map(|key| not_followed(&key))
}

fn not_followed(key: &str) -> String {
    format!("the simulator cannot follow the pack: it has a value of another type or in another unit for `{key}`")
}

/// Reads the payload of a sample.
pub(crate) fn own_payload<R: Fields>(sample: &str) -> Result<R, DecodeError> {
    R::read_fields(&mut Reader::new(sample))
}

/// Returns the report in a packet of samples.
fn extio_report(spec: &Spec) -> Option<ExtioReport> {
    let fields = spec.status_fields().iter();
    let members: Map<_, _> =
        fields.map(|field| (field.wire.clone(), jaka_dynamic::sample_value(spec, field))).collect();
    let packet = RobotStatus::decode(&mut Reader::new(&Value::from(members).to_string())).ok()?;
    packet.extio.and_then(|extio| extio.known().cloned())
}

/// Generates a reply that fits the spec.
fn made_up(spec: &Spec, command: &jaka_spec::Command) -> String {
    accepted(&command.wire, &Value::Object(jaka_dynamic::sample_reply(spec, command)).to_string())
}

/// Returns the reply that accepts a command, with the members of a JSON object.
pub(crate) fn accepted(command: &str, members: &str) -> String {
    let mut out = Writer::new();
    write_refusal(Some(command), ErrorCode::SUCCESS, "", &mut out);
    match (out.as_str().strip_suffix('}'), members.strip_prefix('{')) {
        (Some(envelope), Some(members)) if members != "}" => format!("{envelope},{members}"),
        _ => out.into_string(),
    }
}

/// Returns the usual refusal of a known command.
pub(crate) fn usual_refusal(command: &str) -> (ErrorCode, String) {
    (ErrorCode::CALL_FAILED, format!("call {command} failed"))
}

fn is_success(reply: &str) -> bool {
    Envelope::read(reply).is_ok_and(|envelope| envelope.code.is_ok_and(ErrorCode::is_success))
}
