//! The docs of requests, replies and methods.

use jaka_spec::prose::{code_span, shown};
use jaka_spec::words;
use jaka_spec::{Command, Effect, Example};
use proc_macro2::TokenStream;

use super::{Docs, list, own};

impl<'s> Docs<'s> {
    /// What the request does, what is sent, what that needs, and what comes back.
    pub(crate) fn request_type(self, command: &'s Command) -> TokenStream {
        let reply = self.reply(command).map(|reply| format!(" The reply is {reply}."));
        let method = self.trait_method(command).map(|method| format!(" The method is [`{method}`]."));
        let links = reply.unwrap_or_default() + &method.unwrap_or_default();
        own(&self.about(command, &code_span(&command.wire), &links))
    }

    /// Which request the reply answers.
    pub(crate) fn reply_type(self, command: &Command) -> TokenStream {
        own(&format!("What the controller answers to [`{}`].", self.request(command)))
    }

    /// The same as for the request, with an example, and how the method fails: as `call` does.
    pub(crate) fn method(self, command: &'s Command, call: &str) -> TokenStream {
        let (path, name) = (self.request(command), code_span(&command.wire));
        let sent =
            if command.wire == command.request_type() { format!("[`{path}`]") } else { format!("[{name}]({path})") };
        let about = self.about(command, &sent, "");
        let example = example(&command.examples);
        own(&format!("{about}{example}\n\n# Errors\nAs {call}.{}", refusal(command)))
    }

    /// What a command does; `sent` names it, and `links` lead to what belongs to it.
    fn about(self, command: &'s Command, sent: &str, links: &str) -> String {
        let docs = self.of_command(command);
        let section = command.section.as_ref().map(|section| format!(" ({section})")).unwrap_or_default();
        let changes = if command.effect == Effect::Query { " Changes nothing on the robot." } else { "" };
        let needs = words::requirements(&command.requires).map(|needs| format!(" The robot must be {needs}."));
        let sends = format!("\n\nSends {sent}{section}.{changes}{}{links}", needs.unwrap_or_default());
        docs.prose(&command.doc) + &sends + &docs.prose(&remarks(command))
    }
}

fn remarks(command: &Command) -> String {
    let withdrawn = command.deprecated.as_ref().map(|instead| format!("\n\nWithdrawn by the vendor: {instead}."));
    let evidence = command.evidence.as_ref().map(|evidence| format!("\n\nNot in the document. {evidence}"));
    let reconstructed = command.reconstructed.as_ref();
    let reconstructed =
        reconstructed.map(|evidence| format!("\n\nReconstructed, since the document's page is lost: {evidence}"));
    let errata = (!command.errata.is_empty()).then(|| format!("\n\n# Errata\n\n{}", list(&command.errata)));
    let known = words::known_to(command).map(|known| format!("\n\n{known}"));
    [known, withdrawn, evidence, reconstructed, errata].into_iter().flatten().collect()
}

/// What is sent and what comes back, a message in a line. After an arrow, no message of a pack can end the block.
fn example(examples: &[Example]) -> String {
    let lines = examples.iter().map(|example| {
        let line = |arrow: &str, message: &Option<String>| {
            message.as_ref().map(|message| format!("\n{arrow} {}", shown(message))).unwrap_or_default()
        };
        line("->", &example.request) + &line("<-", &example.reply)
    });
    let lines: String = lines.collect();
    if lines.is_empty() { lines } else { format!("\n\n# Example\n```text{lines}\n```") }
}

/// What the controller does where a requirement is not met.
fn refusal(command: &Command) -> String {
    match &command.refusal {
        _ if command.requires.is_empty() => String::new(),
        None => " In another state than the one it needs, expect a refusal.".to_owned(),
        Some(refusal) => format!(
            " In another state than the one it needs, the controller refuses with code {}, {}.",
            refusal.code,
            code_span(&refusal.message)
        ),
    }
}
