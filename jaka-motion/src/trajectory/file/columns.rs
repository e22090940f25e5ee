//! What the numbers of a file are, by the names that have their units.

/// What six numbers are of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Position,
    Velocity,
    Acceleration,
}

/// In which unit an angle is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Unit {
    Degrees,
    Radians,
}

/// What one number is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Column {
    Time,
    Of(Kind, usize, Unit),
}

impl Kind {
    pub(super) const ALL: [Self; 3] = [Self::Position, Self::Velocity, Self::Acceleration];

    /// Its name for one joint and for all, and what follows the unit of an angle.
    fn names(self) -> [&'static str; 3] {
        match self {
            Self::Position => ["joint", "joints", ""],
            Self::Velocity => ["velocity", "velocity", "_s"],
            Self::Acceleration => ["acceleration", "acceleration", "_s2"],
        }
    }

    /// The name of a column with it.
    pub(super) fn column(self, joint: usize, unit: Unit) -> String {
        let [one, _, per_time] = self.names();
        format!("{one}_{joint}_{}{per_time}", unit.name())
    }

    /// The key of a list with it.
    pub(super) fn key(self, unit: Unit) -> String {
        let [_, all, per_time] = self.names();
        format!("{all}_{}{per_time}", unit.name())
    }
}

impl Unit {
    pub(super) const BOTH: [Self; 2] = [Self::Degrees, Self::Radians];

    fn name(self) -> &'static str {
        match self {
            Self::Degrees => "deg",
            Self::Radians => "rad",
        }
    }

    pub(super) fn to_degrees(self, number: f64) -> f64 {
        match self {
            Self::Degrees => number,
            Self::Radians => number.to_degrees(),
        }
    }
}

impl Column {
    /// The name of the column with times, and their key.
    pub(super) const TIME: &'static str = "time_s";

    /// All columns that there can be, by name.
    pub(super) fn all() -> Vec<(String, Self)> {
        let angles = Kind::ALL.into_iter().flat_map(|kind| {
            let joints = (1..=6).flat_map(|joint| Unit::BOTH.map(|unit| (joint, unit)));
            joints.map(move |(joint, unit)| (kind.column(joint, unit), Self::Of(kind, joint - 1, unit)))
        });
        std::iter::once((Self::TIME.to_owned(), Self::Time)).chain(angles).collect()
    }
}

/// A finite number.
pub(super) fn number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite())
}
