//! How replies are written.

use super::Firmware;
use crate::json_text::Separators;

/// How replies on the command port are written: choices in which firmware differs.
///
/// A reply says the same in every style, and jaka-proto reads the same from it. A style starts from that of a
/// [`Firmware`].
///
/// ```
/// use jaka_sim::{CodeStyle, Controller, Firmware, KeyOrder, ReplyStyle, TruthStyle};
///
/// let style = ReplyStyle::of(Firmware::V1_5_14)
///     .error_code(CodeStyle::Number)
///     .truth_values(TruthStyle::Literals)
///     .key_order(KeyOrder::Reversed);
/// let controller = Controller::builder().firmware(Firmware::V1_5_14).reply_style(style).start()?;
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ReplyStyle {
    pub(super) codes: CodeStyle,
    pub(super) truths: TruthStyle,
    pub(super) numbers: NumberStyle,
    pub(crate) separators: Separators,
    pub(super) key_order: KeyOrder,
    pub(super) success_message: bool,
    pub(super) event: EventStyle,
}

impl ReplyStyle {
    pub(super) const DOCUMENT: Self = Self {
        codes: CodeStyle::Text,
        truths: TruthStyle::Document,
        numbers: NumberStyle::Plain,
        separators: Separators::Compact,
        key_order: KeyOrder::Usual,
        success_message: true,
        event: EventStyle::Absent,
    };

    /// The style of a firmware.
    ///
    /// [`Firmware::Document`] writes replies as the document's examples have them, without blanks.
    /// [`Firmware::V1_5_14`] puts blanks between the parts, writes numbers with a fraction, and tells the controller's
    /// event; [`Firmware::Newer`] does that too, and writes truth values as its packets do.
    pub const fn of(firmware: Firmware) -> Self {
        firmware.shape().reply_style
    }

    /// Chooses how error codes are written.
    #[must_use]
    pub const fn error_code(self, codes: CodeStyle) -> Self {
        Self { codes, ..self }
    }

    /// Chooses how truth values are written.
    #[must_use]
    pub const fn truth_values(self, truths: TruthStyle) -> Self {
        Self { truths, ..self }
    }

    /// Chooses how numbers are written; those of the Python literal in `get_extio_status` stay as they are.
    #[must_use]
    pub const fn numbers(self, numbers: NumberStyle) -> Self {
        Self { numbers, ..self }
    }

    /// Chooses what stands between the parts of a reply.
    #[must_use]
    pub const fn separators(self, separators: Separators) -> Self {
        Self { separators, ..self }
    }

    /// Chooses the order of keys.
    #[must_use]
    pub const fn key_order(self, key_order: KeyOrder) -> Self {
        Self { key_order, ..self }
    }

    /// Leaves out the message of a reply of success.
    #[must_use]
    pub const fn without_success_message(self) -> Self {
        Self { success_message: false, ..self }
    }

    /// Chooses how `get_robot_state` answers the controller's event.
    #[must_use]
    pub const fn event(self, event: EventStyle) -> Self {
        Self { event, ..self }
    }
}

/// The style of the [`Firmware`] that is the default.
impl Default for ReplyStyle {
    fn default() -> Self {
        Self::of(Firmware::default())
    }
}

/// How error codes are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum CodeStyle {
    /// As a string: `"0"`.
    #[default]
    Text,
    /// As a number: `0`.
    Number,
    /// As a string of hexadecimal digits: `"0x0"`. Negative codes, of which no such form is known, as
    /// [`Text`](Self::Text).
    Hexadecimal,
}

/// How truth values are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum TruthStyle {
    /// Each in the form that the document prints for it, such as `"True"`, `"robot_enabled"`, `1` or `true`.
    #[default]
    Document,
    /// Each in the form in which status packets have it: `enabled` as `true`, `powered_on` as `1`. Words that packets
    /// do not have become `true` and `false`, other forms stay.
    Packet,
    /// `true` and `false`.
    Literals,
    /// `1` and `0`.
    Numbers,
    /// `"1"` and `"0"`.
    NumberTexts,
    /// `"True"` and `"False"`.
    Words,
}

/// How numbers are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum NumberStyle {
    /// As short as may be: `3`, `0.5`.
    #[default]
    Plain,
    /// With a fraction throughout, also for whole numbers: `3.0`, `0.5`.
    Fractions,
    /// As strings: `"3"`, `"0.5"`.
    Texts,
    /// As controllers write them: what may have a fraction has one, and counts have none: `3.0` for a mass, `3` for a
    /// level. Joint positions and poses have at most so many decimals: `-263.405107`.
    Decimals(u8),
}

/// How `get_robot_state` answers the controller's event, which status packets have in `errcode`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum EventStyle {
    /// Not at all, as in the document.
    #[default]
    Absent,
    /// As a number, with its message: `17760261`. The vendor's SDK 2.1.14 reads no other form.
    Number,
    /// As the text that status packets have, with its message: `"0x10f0005"`.
    Text,
}

/// The order of a reply's keys.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum KeyOrder {
    /// The error code first, then the message and the name, then the rest in the order of the spec.
    #[default]
    Usual,
    /// The other way round.
    Reversed,
}
