//! All tests through the public interface.

mod files;
mod packs;
mod reports;

use std::collections::BTreeSet;

use jaka_spec::{Event, Severity, Spec, builtin};

fn spec() -> Spec {
    builtin().expect("the built-in spec is correct")
}

/// The figures were taken from the vendor's table itself: JakaCobot.github.io, `docs/en/guide/errinfo.md`, February
/// 2024. The sums tell codes apart that counts do not.
#[test]
fn the_table_has_the_codes_and_severities_of_the_vendors() {
    let spec = spec();
    let of = |severity: Severity| {
        let codes: Vec<_> = spec.events().filter(|event| event.severity == severity).flat_map(Event::codes).collect();
        (codes.len(), codes.iter().map(|code| u64::from(*code)).sum::<u64>())
    };
    assert_eq!(of(Severity::Error), (560, 759_052_835_u64));
    assert_eq!(of(Severity::Warning), (228, 1_010_243_225));
    assert_eq!(of(Severity::Information), (106, 1_865_858_027));
    let codes: BTreeSet<_> = spec.events().flat_map(Event::codes).collect();
    assert_eq!(codes.len(), 894, "no code stands twice");
}

#[test]
fn commands_have_two_names_and_near_ones() {
    let spec = spec();
    let called = |name| spec.command_called(name).map(|command| command.wire.as_str());
    assert_eq!((called("moveL"), called("move_l"), called("MoveL")), (Some("moveL"), Some("moveL"), None));
    let like = |name| spec.command_like(name).map(|command| command.wire.as_str());
    assert_eq!((like("joint_mov"), like("move_ll"), like("x")), (Some("joint_move"), Some("moveL"), None));
}
