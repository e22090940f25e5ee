//! Commands.

use std::slice::from_ref;

use super::collect::Differ;
use super::field::{Holder, fields};
use super::{Impact, made, types};
use crate::{Command, Reply, Request, Role, Scalar, Spec, words};

/// Compares one command of both specs.
pub(super) fn compare(d: &mut Differ<'_>, place: &str, old: &Command, new: &Command) {
    d.value(place, "name", &old.name, &new.name, Impact::Major);
    info(d, place, old, new);
    texts(d, place, old, new);
    request(d, place, old, new);
    reply(d, place, old, new);
}

/// Compares the facts that programs read from `CommandInfo`, and those that decide the client's behaviour.
fn info(d: &mut Differ<'_>, place: &str, old: &Command, new: &Command) {
    d.value(place, "effect", &old.effect.word(), &new.effect.word(), Impact::Minor);
    let role = |command: &Command| command.role.map(Role::word);
    d.option(place, "role", (role(old).as_ref(), role(new).as_ref()), Impact::Minor);
    let changes = |command: &Command| words::changes(&command.changes);
    d.option(place, "change", (changes(old).as_ref(), changes(new).as_ref()), Impact::Minor);
    let motion = |command: &Command| command.motion.as_ref().map(|motion| words::motion(motion, str::to_owned));
    // A program may run it as a motion, and then does not compile any more.
    let lost = if old.motion.is_some() && new.motion.is_none() { Impact::Major } else { Impact::Minor };
    d.option(place, "motion", (motion(old).as_ref(), motion(new).as_ref()), lost);
    let (was, is) = (words::requirements(&old.requires), words::requirements(&new.requires));
    d.option(place, "requirement", (was.as_ref(), is.as_ref()), Impact::Minor);
    d.reworded(place, "remembered setting", &old.remembers, &new.remembers);
    let ms = |command: &Command| command.deadline.map(|deadline| format!("{} ms", deadline.as_millis()));
    d.option(place, "deadline", (ms(old).as_ref(), ms(new).as_ref()), Impact::Minor);
    let now_certain = ("the reply is certain now, and an error if it is missing", Impact::Major);
    let uncertain = ("the reply is no longer certain", Impact::Minor);
    d.flag(place, (old.reply_certain, new.reply_certain), now_certain, uncertain);
    let ends = ("the session ends with it", Impact::Major);
    let goes_on = ("the session goes on after it", Impact::Minor);
    d.flag(place, (old.ends_session, new.ends_session), ends, goes_on);
    let bare = if old.bare_reply.is_none() { Impact::Minor } else { Impact::Major };
    d.option(place, "bare reply", (old.bare_reply.as_ref(), new.bare_reply.as_ref()), bare);
    match (&old.deprecated, &new.deprecated) {
        (None, Some(instead)) => d.note(place, format!("deprecated: {instead}"), Impact::Minor),
        (Some(_), None) => d.note(place, "no longer deprecated", Impact::Patch),
        (old, new) => d.reworded(place, "note of the deprecation", old, new),
    }
}

/// Compares the texts of the docs, and the simulator's answers.
fn texts(d: &mut Differ<'_>, place: &str, old: &Command, new: &Command) {
    d.option(place, "section", (old.section.as_ref(), new.section.as_ref()), Impact::Patch);
    d.versions(place, &old.versions, &new.versions);
    d.reworded(place, "doc", &old.doc, &new.doc);
    d.reworded(place, "aliases", &old.aliases, &new.aliases);
    d.reworded(place, "errata", &old.errata, &new.errata);
    d.reworded(place, "Chinese title", &old.title_zh, &new.title_zh);
    d.reworded(place, "evidence", &old.evidence, &new.evidence);
    d.reworded(place, "evidence of the reconstruction", &old.reconstructed, &new.reconstructed);
    d.reworded(place, "source of the requirement", &old.requires_source, &new.requires_source);
    d.reworded(place, "refusal", &old.refusal, &new.refusal);
    d.reworded(place, "causes of refusals", &old.refused_because, &new.refused_because);
    d.reworded(place, "examples", &old.examples, &new.examples);
}

fn reply(d: &mut Differ<'_>, place: &str, old: &Command, new: &Command) {
    let (Reply::Fields(was), Reply::Fields(is)) = (&old.reply, &new.reply) else {
        let object = |spec: &Spec, command: &Command| match command.reply {
            Reply::Fields(_) => None,
            Reply::Object(id) => Some(spec[id].name.clone()),
            Reply::Raw => Some(Scalar::Json.name().to_owned()),
        };
        let (was, is) = (object(d.old, old), object(d.new, new));
        return d.option(place, "type of the reply", (was.as_ref(), is.as_ref()), Impact::Major);
    };
    fields(d, place, &Holder::reply(was), was, is);
    if !was.is_empty() && !is.is_empty() {
        d.copies(&format!("{place}, reply"), (d.old.all_copy(was), d.new.all_copy(is)));
    }
}

fn request(d: &mut Differ<'_>, place: &str, old: &Command, new: &Command) {
    match (&old.request, &new.request) {
        (Request::Fields(was), Request::Fields(is)) => {
            fields(d, place, &Holder::REQUEST, was, is);
            made::method(d, place, was, is);
        }
        (Request::Choice(was), Request::Choice(is)) => {
            d.value(place, "key of the tag", &was.tag, &is.tag, Impact::Minor);
            types::variants(d, place, &Holder::REQUEST_VARIANT, &was.variants, &is.variants);
        }
        (Request::Fields(_), Request::Choice(_)) => d.note(place, "the request becomes a choice", Impact::Major),
        (Request::Choice(_), Request::Fields(_)) => d.note(place, "the request is no longer a choice", Impact::Major),
    }
    let is_copy = |spec: &Spec, command: &Command| command.request.fields().all(|field| spec.all_copy(from_ref(field)));
    d.copies(&format!("{place}, request"), (is_copy(d.old, old), is_copy(d.new, new)));
}
