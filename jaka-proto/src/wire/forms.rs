//! Forms of values by firmware: the firmware decides in which form a value is written, and how a value is read whose
//! forms are alike in JSON.

use super::reader::Firmware;
use super::{DecodeError, Reader, Writer};
use crate::firmware::{FirmwareRange, FirmwareVersion};

impl<'a> Reader<'a> {
    /// Reads messages of this firmware from the beginning of `text`. Of a firmware that is not known, a value whose
    /// forms are alike in JSON cannot be read.
    pub fn of_firmware(text: &'a str, version: Option<FirmwareVersion>) -> Self {
        let mut reader = Self::new(text);
        reader.set_firmware(version);
        reader
    }

    /// Firmware of the messages, if it is known.
    pub fn firmware(&self) -> Option<FirmwareVersion> {
        match self.firmware {
            Firmware::Version(version) => Some(version),
            Firmware::Unknown | Firmware::Own => None,
        }
    }

    /// Sets the firmware of the messages, in place: moving the reader takes 5 % of the time of reading a short reply.
    #[inline]
    pub(crate) fn set_firmware(&mut self, version: Option<FirmwareVersion>) {
        self.firmware = version.map_or(Firmware::Unknown, Firmware::Version);
    }

    /// Reads values in the spec's own forms, which are those of no firmware in particular.
    #[doc(hidden)]
    pub fn in_own_form(text: &'a str) -> Self {
        let mut reader = Self::new(text);
        reader.firmware = Firmware::Own;
        reader
    }

    /// Reads another text of the same firmware.
    pub(super) fn of_same_firmware<'b>(&self, text: &'b str) -> Reader<'b> {
        let mut reader = Reader::new(text);
        reader.firmware = self.firmware;
        reader
    }

    /// Place of the form that the firmware has, by the firmware of each; none for the value's own form.
    ///
    /// # Errors
    /// The firmware is not known.
    #[doc(hidden)]
    pub fn form(&self, forms: &[FirmwareRange]) -> Result<Option<usize>, DecodeError> {
        match self.firmware {
            Firmware::Unknown => Err(DecodeError::ambiguous()),
            Firmware::Version(version) => Ok(place(forms, version)),
            Firmware::Own => Ok(None),
        }
    }

    /// True if the next value is a string, which may hold a Python literal.
    #[doc(hidden)]
    pub fn is_literal(&mut self) -> bool {
        self.is_text()
    }

    /// True if the next value is an array.
    #[doc(hidden)]
    pub fn is_list(&mut self) -> bool {
        self.is_array()
    }

    /// Reads a truth value, in any of the usual forms or as one of two words, of one of these pairs.
    ///
    /// # Errors
    /// The value is none of these.
    #[doc(hidden)]
    pub fn words(&mut self, words: &[[&str; 2]]) -> Result<bool, DecodeError> {
        let start = self.mark();
        for [off, on] in words {
            if let Ok(value) = self.word(off, on) {
                return Ok(value);
            }
            self.go_back(start);
        }
        self.word("false", "true")
    }
}

impl Writer {
    /// Writer of messages for this firmware. Without one, values are written in the spec's own forms.
    pub fn for_firmware(version: Option<FirmwareVersion>) -> Self {
        let mut writer = Self::new();
        writer.firmware = version;
        writer
    }

    /// Sets the firmware for which messages are written.
    pub fn set_firmware(&mut self, version: Option<FirmwareVersion>) {
        self.firmware = version;
    }

    /// Place of the form that the firmware has, by the firmware of each; none for the value's own form.
    #[doc(hidden)]
    #[must_use]
    pub fn form(&self, forms: &[FirmwareRange]) -> Option<usize> {
        self.firmware.and_then(|version| place(forms, version))
    }
}

fn place(forms: &[FirmwareRange], version: FirmwareVersion) -> Option<usize> {
    forms.iter().position(|form| form.contains(version))
}

/// A number, or what is made of numbers, in another unit.
#[doc(hidden)]
pub trait Scaled {
    /// Multiplies each number by a factor.
    #[must_use]
    fn times(&self, factor: f64) -> Self;
}

impl Scaled for f64 {
    fn times(&self, factor: f64) -> Self {
        self * factor
    }
}

impl<T: Scaled> Scaled for Option<T> {
    fn times(&self, factor: f64) -> Self {
        self.as_ref().map(|value| value.times(factor))
    }
}

impl<T: Scaled> Scaled for Vec<T> {
    fn times(&self, factor: f64) -> Self {
        self.iter().map(|value| value.times(factor)).collect()
    }
}

impl<T: Scaled, const N: usize> Scaled for [T; N] {
    fn times(&self, factor: f64) -> Self {
        self.each_ref().map(|value| value.times(factor))
    }
}
