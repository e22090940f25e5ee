//! Firmware versions, and which of them have a command or a field.

use std::fmt;
use std::str::FromStr;

use crate::text::Visible;

/// A version of a controller's firmware: one to four numbers, such as 1.6.5 or 1.7.1.46.
///
/// Versions are ordered by their numbers: 1.5.14 is after 1.5.9, and 1.6 is just before 1.6.0. Read from the text of
/// `get_version`, such as `1.6.5_01_X86` or `V1.7.0`, or of the vendor's release notes, such as `1_7_2_28`: a `V` may
/// come before the numbers, and words such as `_01_X86` or `-rc2` after them are passed over. Any other text is an
/// error.
///
/// ```
/// use jaka_proto::FirmwareVersion;
///
/// let version: FirmwareVersion = "1.5.14_X64".parse()?;
/// assert!(version > FirmwareVersion::new([1, 5, 9]));
/// assert_eq!(version.to_string(), "1.5.14");
/// # Ok::<(), jaka_proto::InvalidFirmwareVersion>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FirmwareVersion {
    /// Numbers of the version, the major one first; numbers that are not given are zero.
    numbers: [u32; Self::MOST],
    given: u8,
}

impl FirmwareVersion {
    /// Numbers in a version, at most.
    const MOST: usize = 4;

    /// A version of one to four numbers, the major one first.
    pub const fn new<const N: usize>(numbers: [u32; N]) -> Self {
        const { assert!(N >= 1 && N <= Self::MOST, "a firmware version has one to four numbers") };
        let mut version = Self { numbers: [0; Self::MOST], given: 0 };
        while (version.given as usize) < N {
            version.numbers[version.given as usize] = numbers[version.given as usize];
            version.given += 1;
        }
        version
    }

    /// The version with these numbers, the major one first; none unless they are one to four.
    pub fn of(numbers: &[u32]) -> Option<Self> {
        let mut version = Self { numbers: [0; Self::MOST], given: u8::try_from(numbers.len()).ok()? };
        version.numbers.get_mut(..numbers.len()).filter(|_| version.given > 0)?.copy_from_slice(numbers);
        Some(version)
    }

    /// The numbers that are given, the major one first.
    pub fn numbers(&self) -> &[u32] {
        &self.numbers[..usize::from(self.given)]
    }

    /// True if this version begins with `other`'s numbers, as 1.6.5 begins with 1.6.
    fn is_below(&self, other: &Self) -> bool {
        self.numbers.starts_with(other.numbers())
    }
}

impl fmt::Display for FirmwareVersion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [major, others @ ..] = self.numbers() else { return Ok(()) };
        write!(f, "{major}")?;
        others.iter().try_for_each(|number| write!(f, ".{number}"))
    }
}

impl FromStr for FirmwareVersion {
    type Err = InvalidFirmwareVersion;

    fn from_str(text: &str) -> Result<Self, InvalidFirmwareVersion> {
        numbers(text.trim()).ok_or_else(|| InvalidFirmwareVersion { text: text.to_owned() })
    }
}

/// The numbers with which the text begins, if there are one to four that fit. They have dots between them, or
/// underscores if the first of them has one after it.
fn numbers(text: &str) -> Option<FirmwareVersion> {
    let is_no_digit = |c: char| !c.is_ascii_digit();
    let mut rest = text.strip_prefix(['v', 'V']).unwrap_or(text);
    let separator = if rest.trim_start_matches(|c: char| c.is_ascii_digit()).starts_with('_') { '_' } else { '.' };
    let mut version = FirmwareVersion { numbers: [0; FirmwareVersion::MOST], given: 0 };
    loop {
        let end = rest.find(is_no_digit).unwrap_or(rest.len());
        *version.numbers.get_mut(usize::from(version.given))? = rest[..end].parse().ok()?;
        version.given += 1;
        let after = &rest[end..];
        match after.strip_prefix(separator).filter(|next| !next.starts_with(is_no_digit) && !next.is_empty()) {
            Some(next) => rest = next,
            None => return is_addition(after).then_some(version),
        }
    }
}

/// True for what may come after the numbers: nothing, or words of ASCII such as `_01_X86`, `-rc2` or `.X64`.
fn is_addition(text: &str) -> bool {
    let mut characters = text.chars();
    let begins = match (characters.next(), characters.next()) {
        (None, _) => return true,
        (Some('_'), Some(first)) => first.is_ascii_alphanumeric(),
        (Some('-' | '.'), Some(first)) => first.is_ascii_alphabetic(),
        _ => false,
    };
    begins && characters.all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.'))
}

/// A text that is not a firmware version.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct InvalidFirmwareVersion {
    /// The text.
    pub text: String,
}

impl fmt::Display for InvalidFirmwareVersion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` is not a firmware version such as 1.6.5_01_X86", Visible(&self.text))
    }
}

impl std::error::Error for InvalidFirmwareVersion {}

/// The firmware versions that have a command or a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FirmwareRange {
    /// The first of them.
    pub since: Option<FirmwareVersion>,
    /// The last of them, with all below it: 1.6 is the last also for 1.6.5.
    pub until: Option<FirmwareVersion>,
}

impl FirmwareRange {
    /// All versions.
    pub const ALL: Self = Self { since: None, until: None };

    /// Excludes the versions before this one.
    #[must_use]
    pub const fn since<const N: usize>(self, numbers: [u32; N]) -> Self {
        Self { since: Some(FirmwareVersion::new(numbers)), until: self.until }
    }

    /// Excludes the versions after this one.
    #[must_use]
    pub const fn until<const N: usize>(self, numbers: [u32; N]) -> Self {
        Self { since: self.since, until: Some(FirmwareVersion::new(numbers)) }
    }

    /// True if the version has it. A missing number counts as zero: 1.7 has the items since 1.7.0.
    pub fn contains(&self, version: FirmwareVersion) -> bool {
        let is_begun = self.since.is_none_or(|since| version.numbers >= since.numbers);
        let is_over = self.until.is_some_and(|until| version > until && !version.is_below(&until));
        is_begun && !is_over
    }
}

/// In words, such as `1.7 and later` or `1.5 to 1.6`.
impl fmt::Display for FirmwareRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.since, self.until) {
            (Some(since), Some(until)) => write!(f, "{since} to {until}"),
            (Some(since), None) => write!(f, "{since} and later"),
            (None, Some(until)) => write!(f, "up to {until}"),
            (None, None) => f.write_str("of any version"),
        }
    }
}

/// A request with something that the controller's firmware does not have. Nothing was sent.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct NotInFirmware {
    /// `cmdName` of the request.
    pub command: String,
    /// The field's Rust name, such as `pose.x`; `None` if the firmware lacks the command itself.
    pub field: Option<String>,
    /// The value of the field, if the firmware lacks the value.
    pub value: Option<String>,
    /// The controller's firmware.
    pub firmware: FirmwareVersion,
    /// The firmware that has it.
    pub range: FirmwareRange,
}

impl NotInFirmware {
    /// A request for this command with something that firmware has only in this range: the command itself, or a field.
    pub fn new(
        command: impl Into<String>,
        field: Option<String>,
        firmware: FirmwareVersion,
        range: FirmwareRange,
    ) -> Self {
        Self { command: command.into(), field, value: None, firmware, range }
    }

    /// Narrows the error from the field as a whole to one value of the field.
    #[must_use]
    pub fn with_value(self, value: impl Into<String>) -> Self {
        Self { value: Some(value.into()), ..self }
    }
}

impl fmt::Display for NotInFirmware {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { command, field, value, firmware, range } = self;
        write!(f, "`{command}` was not sent: the controller's firmware {firmware} does not have ")?;
        match (field, value) {
            (Some(field), Some(value)) => write!(f, "the value {value} of its field `{field}`")?,
            (Some(field), None) => write!(f, "its field `{field}`")?,
            (None, _) => f.write_str("it")?,
        }
        write!(f, "; firmware {range} has")
    }
}

impl std::error::Error for NotInFirmware {}
