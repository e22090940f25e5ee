//! What the spec says about each command, by the command's name.

use std::collections::{BTreeSet, HashMap};
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};
use std::{fs, io};

use jaka_proto::wire::Writer;
use jaka_proto::{Command, Envelope, ErrorCode, FirmwareRange, Request, read_payload, write_refusal};
use jaka_spec::{Effect, Field, Requirement, Source, Spec, Version, Versions};
use serde_json::Value;

/// A spec, indexed by `cmdName`.
#[derive(Debug)]
pub(crate) struct SpecIndex {
    entries: HashMap<String, CommandEntry>,
    /// All of it.
    pub(crate) spec: Spec,
    /// True if a pack changes what status packets have without it.
    changed_status: bool,
    /// The controller's message for something that is not a command.
    pub(crate) unknown: String,
}

/// What the spec says about one command.
#[derive(Debug)]
pub(crate) struct CommandEntry {
    /// All of it.
    pub(crate) command: jaka_spec::Command,
    /// True for a command that moves the arm: one that needs it enabled to do so.
    pub(crate) moves: bool,
    /// True for one that a pack adds or changes.
    pub(crate) packed: bool,
    /// The firmware that has it, where a pack says so, or the document does not have it.
    beyond: Option<FirmwareRange>,
    /// The code and message of the refusal in a wrong state.
    pub(crate) refusal: (ErrorCode, String),
    /// The first successful reply that the spec prints, or one that is made up where it prints none or a pack changes it.
    pub(crate) sample: String,
    /// The same by the built-in spec, if it has the command.
    pub(crate) typed_sample: String,
}

impl SpecIndex {
    /// The index of the built-in spec, which is read once in a process.
    fn built_in() -> io::Result<Arc<Self>> {
        static BUILT_IN: OnceLock<Arc<SpecIndex>> = OnceLock::new();
        if let Some(index) = BUILT_IN.get() {
            return Ok(Arc::clone(index));
        }
        let spec = jaka_spec::builtin().map_err(io::Error::other)?;
        Ok(Arc::clone(BUILT_IN.get_or_init(|| Arc::new(Self::new(spec, None, &BTreeSet::new())))))
    }

    /// The index of the built-in spec with packs, each of which adds to those before it.
    pub(crate) fn open(packs: &[PathBuf]) -> io::Result<Arc<Self>> {
        let built_in = Self::built_in()?;
        if packs.is_empty() {
            return Ok(built_in);
        }
        let mut spec = built_in.spec.clone();
        let mut packed = BTreeSet::new();
        for path in packs {
            let name = path.display().to_string();
            let text = fs::read_to_string(path)
                .map_err(|error| io::Error::new(error.kind(), format!("cannot read the pack `{name}`: {error}")))?;
            let pack = jaka_spec::load_pack(&spec, Source { path: &name, text: &text })
                .map_err(|errors| io::Error::new(io::ErrorKind::InvalidData, errors))?;
            let changed: BTreeSet<_> =
                pack.module().topic.commands.iter().map(|command| command.wire.clone()).collect();
            check_followed(&built_in, &pack.spec, &changed)
                .map_err(|why| io::Error::new(io::ErrorKind::Unsupported, format!("the pack `{name}`: {why}")))?;
            packed.extend(changed);
            spec = pack.spec;
        }
        Ok(Arc::new(Self::new(spec, Some(&built_in), &packed)))
    }

    /// The index of a spec that packs have made of another one, and the commands that they add or change.
    fn new(spec: Spec, base: Option<&Self>, packed: &BTreeSet<String>) -> Self {
        let entry = |command: &jaka_spec::Command| {
            let base = base.and_then(|base| base.entry(&command.wire));
            CommandEntry::new(&spec, command, base, packed.contains(&command.wire))
        };
        let entries = spec.commands().map(|command| (command.wire.clone(), entry(command))).collect();
        let exception = spec.errors().find(|error| error.wire == ErrorCode::EXCEPTION.0);
        let unknown = exception.and_then(|error| error.message.clone()).unwrap_or_default();
        let changed_status = base.is_some_and(|base| changes_status(&base.spec, &spec));
        Self { entries, spec, changed_status, unknown }
    }

    pub(crate) fn entry(&self, command: &str) -> Option<&CommandEntry> {
        self.entries.get(command)
    }

    /// True if a value can stand at a key of status packets, which a pack may have changed.
    pub(crate) fn fits(&self, field: &Field, value: &Value) -> bool {
        !self.changed_status || jaka_dynamic::is_readable(&self.spec, field, value)
    }

    /// The reply that the spec prints for a command.
    pub(crate) fn example<C: Command>(&self) -> io::Result<C::Reply> {
        let entry = self.entry(C::INFO.name);
        let entry = entry.ok_or_else(|| io::Error::other(format!("the spec does not have `{}`", C::INFO.name)))?;
        read_payload(C::INFO, &entry.typed_sample).map_err(io::Error::other)
    }
}

impl CommandEntry {
    fn new(spec: &Spec, command: &jaka_spec::Command, base: Option<&Self>, packed: bool) -> Self {
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
            beyond,
            refusal: own.unwrap_or_else(|| usual_refusal(&command.wire)),
            typed_sample: base.map_or_else(|| sample.clone(), |base| base.typed_sample.clone()),
            sample,
            command: command.clone(),
        }
    }

    /// Whether firmware of this version has the command. One whose version cannot be read has all.
    pub(crate) fn is_in_firmware(&self, version: &str) -> bool {
        self.beyond.is_none_or(|range| version.parse().map_or(true, |version| range.contains(version)))
    }
}

/// Fails where a pack names or types a key otherwise than the built-in spec has it: the state has no value for it, and
/// zeros in its place would be false.
fn check_followed(built_in: &SpecIndex, spec: &Spec, changed: &BTreeSet<String>) -> Result<(), String> {
    for name in changed {
        let (Some(entry), Some(command)) = (built_in.entry(name), spec.command(name)) else { continue };
        let is_kept = |field: &Field| command.request.fields().any(|other| other.wire == field.wire);
        if let Some(field) = entry.command.request.fields().find(|field| !is_kept(field)) {
            return Err(format!(
                "the simulator cannot follow it: it changes `{}` in the request `{name}`, which the simulated arm reads by that name",
                field.wire
            ));
        }
        let sample: Value = serde_json::from_str(&entry.typed_sample).map_err(|error| error.to_string())?;
        let before = built_in.spec.reply_fields(&entry.command);
        let value = |field: &Field| sample.get(&field.wire).cloned();
        if let Some(key) = not_followed((before, spec.reply_fields(command)), spec, value) {
            return Err(format!(
                "the simulator cannot follow it: it changes `{key}` in the reply to `{name}`, for which the simulated arm has a value of \
                 another name or type"
            ));
        }
    }
    let value = |field: &Field| Some(jaka_dynamic::sample_value(&built_in.spec, field));
    not_followed((built_in.spec.status_fields(), spec.status_fields()), spec, value).map_or(Ok(()), |key| {
        Err(format!(
            "the simulator cannot follow it: it changes `{key}` in status packets, for which the simulated arm has a value of another type"
        ))
    })
}

/// The first key that is not there any more, or cannot have the value that it had.
fn not_followed<'f>(
    (before, after): (&'f [Field], &[Field]),
    spec: &Spec,
    value: impl Fn(&Field) -> Option<Value>,
) -> Option<&'f str> {
    let is_followed = |field: &Field| {
        let same = after.iter().find(|other| other.wire == field.wire);
        same.is_some_and(|other| value(field).is_none_or(|value| jaka_dynamic::is_readable(spec, other, &value)))
    };
    before.iter().find(|field| !is_followed(field)).map(|field| &*field.wire)
}

/// The versions of the firmware that has a command of a pack.
fn firmware_range(versions: &Versions) -> FirmwareRange {
    let bound = |version: &Option<Version>| version.as_ref().and_then(|version| version.to_string().parse().ok());
    FirmwareRange { since: bound(&versions.since), until: bound(&versions.until) }
}

/// True if packs have changed keys of status packets that the spec before them has, or types.
fn changes_status(before: &Spec, after: &Spec) -> bool {
    before.status_fields().iter().any(|field| !after.status_fields().contains(field))
        || before.types().any(|(id, def)| Some(id) != before.status_type() && after[id] != *def)
}

/// A reply that fits the spec.
fn made_up(spec: &Spec, command: &jaka_spec::Command) -> String {
    accepted(&command.wire, &Value::Object(jaka_dynamic::sample_reply(spec, command)).to_string())
}

/// The reply that accepts a command, with the members of a JSON object.
pub(crate) fn accepted(command: &str, members: &str) -> String {
    let mut out = Writer::new();
    write_refusal(Some(command), ErrorCode::SUCCESS, "", &mut out);
    match (out.as_str().strip_suffix('}'), members.strip_prefix('{')) {
        (Some(envelope), Some(members)) if members != "}" => format!("{envelope},{members}"),
        _ => out.into_string(),
    }
}

/// How controllers refuse a command that they know.
pub(crate) fn usual_refusal(command: &str) -> (ErrorCode, String) {
    (ErrorCode::CALL_FAILED, format!("call {command} failed"))
}

fn is_success(reply: &str) -> bool {
    Envelope::read(reply).is_ok_and(|envelope| envelope.code.is_ok_and(ErrorCode::is_success))
}
