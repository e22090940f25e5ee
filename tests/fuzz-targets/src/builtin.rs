//! The built-in spec, loaded once.

use std::collections::HashMap;
use std::sync::LazyLock;

use jaka_proto::Request;
use jaka_spec::Spec;

pub(crate) static SPEC: LazyLock<Spec> = LazyLock::new(|| jaka_spec::builtin().expect("the built-in spec is correct"));

/// A request of each command, which stands for its types.
pub(crate) static COMMANDS: LazyLock<HashMap<&str, Request>> = LazyLock::new(|| {
    let example = |command: &'static jaka_spec::Command| {
        let text = command.examples.iter().find_map(|example| example.request.as_deref());
        let request = Request::read(text.expect("each command has an example")).expect("the examples decode");
        (command.wire.as_str(), request)
    };
    SPEC.commands().map(example).collect()
});
