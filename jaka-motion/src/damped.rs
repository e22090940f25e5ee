//! Turns of joints that move the tool.

use nalgebra::{Matrix6, Vector6};

/// Jacobian, factorised for solution by least squares. Damping limits a joint that hardly moves the tool.
#[derive(Debug, Clone)]
pub(crate) struct Damped {
    jacobian: Matrix6<f64>,
    /// Cholesky factor of the Jacobian times its transpose plus the damping: the lower triangle, with the inverse of
    /// each diagonal entry.
    lower: [[f64; 6]; 6],
}

impl Damped {
    /// Factorises a Jacobian, with `damping` added to the squares of the singular values; `None` if numbers are not
    /// finite.
    pub(crate) fn new(jacobian: &Matrix6<f64>, damping: f64) -> Option<Self> {
        let mut lower = [[0.0; 6]; 6];
        for column in jacobian.as_slice().chunks_exact(6) {
            for (row, entries) in lower.iter_mut().enumerate() {
                for (entry, other) in entries.iter_mut().zip(column).take(row + 1) {
                    *entry += column[row] * other;
                }
            }
        }
        for row in 0..6 {
            let (above, below) = lower.split_at_mut(row);
            let entries = &mut below[0];
            for (column, other) in above.iter().enumerate() {
                entries[column] = (entries[column] - product(entries, other, column)) * other[column];
            }
            let left = entries[row] + damping - product(entries, entries, row);
            if left.is_nan() || left <= 0.0 {
                return None;
            }
            entries[row] = left.sqrt().recip();
        }
        Some(Self { jacobian: *jacobian, lower })
    }

    /// Returns the turns in radians for a motion of the tool, approximate at a singularity.
    pub(crate) fn turns(&self, moved: &Vector6<f64>) -> Vector6<f64> {
        let mut solved: [f64; 6] = (*moved).into();
        for row in 0..6 {
            let entries = &self.lower[row];
            solved[row] = (solved[row] - product(entries, &solved, row)) * entries[row];
        }
        for row in (0..6).rev() {
            let later: f64 = (row + 1..6).map(|other| self.lower[other][row] * solved[other]).sum();
            solved[row] = (solved[row] - later) * self.lower[row][row];
        }
        self.jacobian.tr_mul(&Vector6::from(solved))
    }

    /// Returns the motion of the tool for turns in radians.
    pub(crate) fn moved(&self, turns: &Vector6<f64>) -> Vector6<f64> {
        self.jacobian * turns
    }
}

/// Returns the scalar product of the first `count` entries of two rows.
fn product(one: &[f64; 6], other: &[f64; 6], count: usize) -> f64 {
    one.iter().zip(other).take(count).map(|(one, other)| one * other).sum()
}
