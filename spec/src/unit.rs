//! Units, and how they relate.

use std::f64::consts::PI;

/// Factor from a number in one unit to the same in another; none for units of which no factor is known.
pub fn unit_factor(from: &str, to: &str) -> Option<f64> {
    const UNITS: &[&[(&str, f64)]] = &[
        &[("deg", PI / 180.0), ("rad", 1.0)],
        &[("mm", 0.001), ("m", 1.0)],
        &[("ms", 0.001), ("s", 1.0)],
        &[("g", 0.001), ("kg", 1.0)],
    ];
    let parts =
        |unit: &'_ str| unit.split_once('/').map_or((unit.to_owned(), None), |(a, b)| (a.into(), Some(b.to_owned())));
    let ((from, from_per), (to, to_per)) = (parts(from), parts(to));
    let size = |units: &[(&str, f64)], unit: &str| units.iter().find(|(name, _)| *name == unit).map(|(_, size)| *size);
    if from_per != to_per {
        return None;
    }
    if from == to {
        return Some(1.0);
    }
    UNITS.iter().find_map(|units| Some(size(units, &from)? / size(units, &to)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_one_quantity_convert() {
        assert_eq!(unit_factor("rad/s", "deg/s"), Some(180.0 / PI));
        assert_eq!(unit_factor("m", "mm"), Some(1000.0));
        assert_eq!(unit_factor("mm", "mm"), Some(1.0));
        for (from, to) in [("rad", "mm"), ("rad/s", "deg"), ("deg/s", "deg/s²"), ("Hz", "ms")] {
            assert_eq!(unit_factor(from, to), None, "{from} to {to}");
        }
    }
}
