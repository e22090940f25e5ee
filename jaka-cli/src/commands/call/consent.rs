//! Asking before something happens to the robot.

use std::io::{self, BufRead, IsTerminal, Write, stderr, stdin};

use jaka_spec::{Effect, first_sentence};
use jaka_sync::motion::Jog;
use jaka_sync::proto;

use super::help;
use super::options::Options;
use super::request::Request;
use crate::failure::Failure;

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
            "`{}` was not sent: what it does is not known when it is sent unchecked; say --yes if you know",
            request.name
        )));
    }
    if !stdin().is_terminal() {
        return Err(Failure::Usage(format!(
            "`{}` was not sent: it {}, and nobody can be asked here; say --yes to send it all the same",
            request.name,
            effect(request)
        )));
    }
    let question = question(request, title);
    match ask(&question, &mut stdin().lock(), &mut stderr()) {
        Ok(true) => Ok(()),
        Ok(false) => Err(Failure::Usage(format!("`{}` was not sent", request.name))),
        Err(error) => Err(Failure::local("cannot ask", error)),
    }
}

/// True for what is sent without a question: what only reads, what concerns the connection alone, and what stops the arm, for
/// a stop must not wait.
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
    format!("To {title}:\n  {}\n`{}` {}. {about}\nSend it? [y/N] ", request.text, request.name, effect(request))
}

/// True if the answer is yes.
fn ask(question: &str, input: &mut impl BufRead, output: &mut impl Write) -> io::Result<bool> {
    output.write_all(question.as_bytes())?;
    output.flush()?;
    let mut answer = String::new();
    input.read_line(&mut answer)?;
    Ok(matches!(answer.trim().to_ascii_lowercase().as_str(), "y" | "yes"))
}
