//! What is advised of numbers.

/// How great a number may be unless that is left to the controller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Advice<'u> {
    /// Greatest magnitude.
    pub max: f64,
    /// True where the number should not be zero either.
    pub nonzero: bool,
    /// Unit of the numbers concerned; empty for all numbers of the field.
    pub unit: &'u str,
}

/// What is advised of the numbers of a field: at most one [`Advice`] for each unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Advised<'u> {
    rows: &'u [Advice<'u>],
    times: f64,
}

impl<'u> Advised<'u> {
    /// Nothing.
    pub const NONE: Self = Self::to(&[]);

    /// These rows.
    pub const fn to(rows: &'u [Advice<'u>]) -> Self {
        Self { rows, times: 1.0 }
    }

    /// The same with bounds that are as many times as great; once where no count is given, or one that is not positive.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "counts are small whole numbers")]
    pub fn times(self, count: impl Into<Option<i64>>) -> Self {
        Self { times: count.into().unwrap_or(1).max(1) as f64, ..self }
    }

    /// True where nothing is advised.
    pub const fn is_none(&self) -> bool {
        self.rows.is_empty()
    }

    /// True for a number in this unit that is within the bounds.
    pub(super) fn allow(&self, value: f64, unit: &str) -> bool {
        self.of(unit).is_none_or(|row| value.abs() <= row.max && !(row.nonzero && value == 0.0))
    }

    /// What is advised of a number in this unit.
    pub(super) fn of(&self, unit: &str) -> Option<Advice<'u>> {
        let row = self.rows.iter().find(|row| row.unit.is_empty() || row.unit == unit)?;
        Some(Advice { max: row.max * self.times, ..*row })
    }
}
