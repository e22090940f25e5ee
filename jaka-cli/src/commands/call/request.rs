//! Request, from fields or as a whole.

use std::io;

use jaka_dynamic::{AdvisoryRanges, Problem};
use jaka_spec::{COMMAND_NAME, Command, Effect, Spec};
use serde_json::{Map, Value};

use super::parser::CommandLine;
pub(super) use crate::arm::consent::Intent as Request;
use crate::arm::units::other_unit;
use crate::failure::Failure;

/// Returns the request of a line; `None` if it names no command.
///
/// # Errors
/// All violations of the spec.
pub(super) fn of_line<'s>(
    spec: &'s Spec,
    command: Option<&'s Command>,
    name: Option<&str>,
    line: &CommandLine,
) -> Result<Option<Request<'s>>, Failure> {
    let options = &line.options;
    let params = options.params.as_deref().map(read).transpose()?;
    if options.raw {
        return unchecked(name, params.as_deref().unwrap_or("{}")).map(Some);
    }
    let ranges = options.advisory_ranges;
    match (command, params) {
        (_, Some(text)) => of_text(spec, command, &text, ranges).map(Some),
        (Some(command), None) => of_fields(spec, command, &line.fields, ranges).map(Some),
        (None, None) => Ok(None),
    }
}

/// Returns the request of a JSON object, which names the command if that is not known.
///
/// # Errors
/// All violations of the spec.
pub(super) fn of_text<'s>(
    spec: &'s Spec,
    command: Option<&'s Command>,
    text: &str,
    ranges: AdvisoryRanges,
) -> Result<Request<'s>, Failure> {
    let (name, fields) = object(text)?;
    let command = match (command, &name) {
        (Some(command), None) => command,
        (Some(command), Some(name)) if *name == command.wire => command,
        (Some(command), Some(name)) => return Err(two_names(&command.wire, name)),
        (None, Some(Value::String(name))) => super::find(spec, name)?,
        (None, _) => return Err(nameless()),
    };
    of_fields(spec, command, &fields, ranges)
}

fn of_fields<'s>(
    spec: &Spec,
    command: &'s Command,
    fields: &Map<String, Value>,
    ranges: AdvisoryRanges,
) -> Result<Request<'s>, Failure> {
    let text =
        jaka_dynamic::request(spec, command, fields, ranges).map_err(|problems| forbidden(command, &problems))?;
    Ok(Request { command: Some(command), name: command.wire.clone(), text })
}

/// Reads the text of `--params`.
fn read(params: &str) -> Result<String, Failure> {
    let text = match params.strip_prefix('@') {
        Some(path) => jaka_spec::read_text(path)
            .map_err(|error| Failure::Usage(format!("cannot read the request in {path}: {error}")))?,
        None if params == "-" => jaka_spec::text_of(io::stdin())
            .map_err(|error| Failure::local("cannot read the request on standard input", error))?,
        None => params.to_owned(),
    };
    Ok(text.trim().to_owned())
}

/// Splits a whole request into its `cmdName` and its fields.
fn object(text: &str) -> Result<(Option<Value>, Map<String, Value>), Failure> {
    let mut fields: Map<String, Value> = serde_json::from_str(text)
        .map_err(|error| Failure::Usage(format!("the request is not a JSON object: {error}")))?;
    Ok((fields.remove(COMMAND_NAME), fields))
}

/// Returns a request unchecked, with the command's name added if it has none.
fn unchecked<'s>(name: Option<&str>, text: &str) -> Result<Request<'s>, Failure> {
    let (own, fields) = object(text)?;
    let (name, text) = match (name, own) {
        (Some(name), None) => {
            let rest = text.trim_start_matches('{').trim_start();
            let comma = if fields.is_empty() { "" } else { "," };
            (name.to_owned(), format!("{{\"{COMMAND_NAME}\":{}{comma}{rest}", Value::from(name)))
        }
        (Some(name), Some(own)) if own != name => return Err(two_names(name, &own)),
        (_, Some(Value::String(own))) if !own.is_empty() => (own, text.to_owned()),
        _ => return Err(nameless()),
    };
    Ok(Request { command: None, name, text })
}

fn two_names(command: &str, name: &Value) -> Failure {
    Failure::Usage(format!("the request names {name}, the command line `{command}`"))
}

fn nameless() -> Failure {
    Failure::Usage(format!("no command name: give it on the command line, or as `{COMMAND_NAME}` in the request"))
}

fn forbidden(command: &Command, problems: &[Problem]) -> Failure {
    let lines: Vec<_> = problems.iter().map(|problem| format!("\n  {problem}")).collect();
    let hint = if problems.iter().all(|problem| problem.advisory) {
        "\nhint: `--advisory-ranges ignore` leaves the check to the controller"
    } else {
        ""
    };
    // In settings, numbers with these units may have another meaning.
    let mut of_motion = problems.iter().filter(|_| command.effect == Effect::Motion);
    let unit = of_motion.find_map(|problem| other_unit(problem.value.parse().ok()?, &problem.allowed));
    Failure::Usage(format!("`{}` was not sent:{}{}{hint}", command.wire, lines.concat(), unit.unwrap_or_default()))
}
