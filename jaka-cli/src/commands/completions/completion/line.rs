//! A command line up to the cursor.

use clap::{Arg, Command, Id};
use jaka_spec::Spec;

/// What is known of a line up to the cursor.
pub(super) struct Line<'c> {
    /// The command that the words so far lead to.
    pub(super) command: &'c Command,
    pub(super) spec: &'c Spec,
    /// What stands without a name.
    pub(super) positionals: Vec<&'c str>,
    /// The options that are given, each with its value if it has one.
    pub(super) options: Vec<(&'c Arg, Option<&'c str>)>,
    pub(super) given: Vec<&'c Id>,
    /// The option whose value comes next.
    pending: Option<&'c Arg>,
    /// What follows has no names.
    is_escaped: bool,
}

/// What the word at the cursor is.
pub(super) enum Place<'c, 'w> {
    /// The value of an argument.
    Value(&'c Arg),
    /// The same, after its name, such as `--mode`, and an equals sign.
    ValueInWord(&'c Arg, &'w str, &'w str),
    /// The name of an option.
    Option,
    /// A command, or what has no name.
    Word,
}

impl<'c> Line<'c> {
    pub(super) fn of(tree: &'c Command, spec: &'c Spec, words: &'c [String]) -> Self {
        let mut line = Self {
            command: tree,
            spec,
            positionals: Vec::new(),
            options: Vec::new(),
            given: Vec::new(),
            pending: None,
            is_escaped: false,
        };
        for word in words {
            line.add(word);
        }
        line
    }

    /// What this word is.
    pub(super) fn place<'w>(&self, word: &'w str) -> Place<'c, 'w> {
        if let Some(option) = self.pending.filter(|option| takes(option, word)) {
            return Place::Value(option);
        }
        if self.is_escaped || !word.starts_with('-') {
            return Place::Word;
        }
        let Some((name, value)) = word.split_once('=') else { return Place::Option };
        match self.long(name) {
            Some(option) => Place::ValueInWord(option, name, value),
            None => Place::Option,
        }
    }

    /// The argument without a name that comes next.
    pub(super) fn positional(&self) -> Option<&'c Arg> {
        self.command.get_positionals().nth(self.positionals.len())
    }

    fn add(&mut self, word: &'c str) {
        if let Some(option) = self.pending.take()
            && takes(option, word)
        {
            return self.options.push((option, Some(word)));
        }
        if self.is_escaped || !word.starts_with('-') || word == "-" {
            return self.add_word(word);
        }
        if word == "--" {
            self.is_escaped = true;
            return;
        }
        let (name, value) = word.split_once('=').map_or((word, None), |(name, value)| (name, Some(value)));
        let option = self.long(name).or_else(|| self.short(name));
        let Some(option) = option else { return };
        self.given.push(option.get_id());
        let is_flag = !option.get_action().takes_values() || option.is_require_equals_set();
        if value.is_some() || is_flag {
            self.options.push((option, value));
        } else {
            self.pending = Some(option);
        }
    }

    fn add_word(&mut self, word: &'c str) {
        // Commands of the protocol also have names in Rust.
        let wire = || self.spec.command_called(word).map(|command| command.wire.as_str());
        let found = self.command.find_subcommand(word);
        let found = found.or_else(|| self.command.find_subcommand(wire()?));
        match found.filter(|_| self.positionals.is_empty()) {
            Some(command) => self.command = command,
            None => self.positionals.push(word),
        }
    }

    /// The option of a name such as `--mode`.
    fn long(&self, name: &str) -> Option<&'c Arg> {
        let name = name.strip_prefix("--")?;
        let has = |arg: &&Arg| {
            arg.get_long() == Some(name) || arg.get_all_aliases().is_some_and(|aliases| aliases.contains(&name))
        };
        self.command.get_arguments().find(has)
    }

    /// The last of several such as `-yr`: it may take a value.
    fn short(&self, names: &str) -> Option<&'c Arg> {
        let last = names.chars().next_back();
        self.command.get_arguments().find(|arg| arg.get_short().is_some() && arg.get_short() == last)
    }
}

/// True if the word is the option's value.
fn takes(option: &Arg, word: &str) -> bool {
    let needs_one = option.get_num_args().is_none_or(|count| count.min_values() > 0);
    needs_one || !word.starts_with('-')
}
