//! The prose in front of the generated part, in reading order.

/// The pages of the English edition.
pub(super) const ENGLISH: [&str; 13] = [
    include_str!("../../../reference/about.md"),
    include_str!("../../../reference/session.md"),
    include_str!("../../../reference/programs.md"),
    include_str!("../../../reference/framing.md"),
    include_str!("../../../reference/packet.md"),
    include_str!("../../../reference/states.md"),
    include_str!("../../../reference/conventions.md"),
    include_str!("../../../reference/events.md"),
    include_str!("../../../reference/refusals.md"),
    include_str!("../../../reference/queries.md"),
    include_str!("../../../reference/firmware.md"),
    include_str!("../../../reference/traps.md"),
    include_str!("../../../reference/tables.md"),
];

/// The front matter and the traps of the Chinese edition.
pub(super) const CHINESE: [&str; 2] =
    [include_str!("../../../reference/zh/about.md"), include_str!("../../../reference/zh/traps.md")];

/// The heading of the Chinese edition's errata.
pub(super) const CHINESE_ERRATA: &str = include_str!("../../../reference/zh/errata.md");

/// The heading of the Chinese edition's index.
pub(super) const CHINESE_INDEX: &str = include_str!("../../../reference/zh/index.md");

/// The texts of the Chinese edition's errata: TOML, the Chinese ones by the English ones.
pub(super) const CHINESE_ERRATA_TEXTS: &str = include_str!("../../../reference/zh/errata.toml");
