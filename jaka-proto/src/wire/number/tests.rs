use proptest::prelude::*;

use super::*;

/// Checks that the usual form, if the text is in it, gives the same number as the standard library.
fn check(text: &str) -> Result<(), TestCaseError> {
    let followed = format!("{text},");
    if let Some((value, len)) = f64::usual(followed.as_bytes()) {
        let expected: f64 = text.parse().expect("the standard library takes it too");
        prop_assert_eq!((value.to_bits(), len), (expected.to_bits(), text.len()), "{}", text);
    }
    if let Some((value, len)) = i64::usual(followed.as_bytes()) {
        prop_assert_eq!((Ok(value), len), (text.parse(), text.len()), "{}", text);
    }
    Ok(())
}

/// So many numbers of each kind: millions with `JAKA_RELIABILITY=100`.
fn numbers() -> ProptestConfig {
    let times: u32 = std::env::var("JAKA_RELIABILITY").ok().and_then(|times| times.parse().ok()).unwrap_or(1);
    ProptestConfig::with_cases(2_000 * times)
}

proptest! {
    #![proptest_config(numbers())]

    #[test]
    fn floats_as_they_are_printed(value in any::<f64>().prop_filter("JSON has finite numbers only", |value| value.is_finite())) {
        check(&value.to_string())?;
    }

    #[test]
    fn positions_of_full_precision(value in -1000.0..1000.0) {
        let text = f64::to_string(&value);
        check(&text)?;
        prop_assert!(f64::usual(format!("{text}]").as_bytes()).is_some() || text.len() > 20, "{}", text);
    }

    #[test]
    fn whole_numbers_of_up_to_18_digits(value in any::<i64>(), digits in 0..18_u32) {
        let value = value % 10_i64.pow(digits + 1);
        let text = format!("{value},");
        prop_assert_eq!(i64::usual(text.as_bytes()), Some((value, text.len() - 1)));
    }

    #[test]
    fn any_digits(digits in any::<u64>(), point in 0..21_usize, sign in "-?0{0,3}") {
        let mut text = digits.to_string();
        if point < text.len() {
            text.insert(text.len() - point, '.');
        }
        check(&(sign + &text))?;
    }

    /// Numbers that are hardest to round: exactly in the middle between two floats, and next to it.
    #[test]
    fn middles_between_two_floats(odd in 1_u64 << 53..1 << 54, shift in 0..8_u32, neighbour in -1_i64..=1, point in 0..19_usize) {
        let digits = ((odd | 1) << shift).saturating_add_signed(neighbour).to_string();
        check(&digits)?;
        let (whole, fraction) = digits.split_at(digits.len().saturating_sub(point).max(1));
        check(&format!("{whole}.{fraction}"))?;
    }

    /// Numbers for which the quotient by whole numbers has the fewest bits to spare.
    #[test]
    fn small_numbers_of_18_places(digits in 1_u64 << 53..1 << 57) {
        let text = format!("0.{digits:018}");
        prop_assert_eq!(f64::usual(format!("{text},").as_bytes()), Some((text.parse().expect("it is one"), text.len())));
    }

    /// Halves, quarters and so on of whole numbers can lie in the middle as well: they end in fives.
    #[test]
    fn middles_with_a_fraction(whole in 1_u64 << 49..1 << 50, parts in 0..16_u32) {
        // 2^53 lies between; sixteenths of these take four digits.
        check(&format!("{whole}.{:04}", parts * 625))?;
    }

    #[test]
    fn whatever_looks_like_a_number(text in "-?[0-9]{0,20}[.]?[0-9]{0,20}([eE][+-]?[0-9]{0,3})?") {
        check(&text)?;
        prop_assert_eq!(is_number(&text), text.parse::<f64>().is_ok(), "{}", text);
    }

    #[test]
    fn a_run_goes_up_to_an_unusual_number(
        elements in prop::collection::vec((any::<i32>(), prop::sample::select(vec![",", ", "])), 1..9),
        after in prop::sample::select(vec!["]", ",]", ", ]", " ,1", ",  1]", ", \"1\"]", ",1e5]", ", 1"]),
    ) {
        let mut text = String::new();
        for (at, (number, comma)) in elements.iter().enumerate() {
            text += if at == 0 { "" } else { comma };
            text += &number.to_string();
        }
        let (expected, len) = (elements.iter().map(|(number, _)| f64::from(*number)).collect::<Vec<_>>(), text.len());
        text += after;
        let mut found = Vec::new();
        prop_assert_eq!(run(text.as_bytes(), |number: f64| found.push(number)), (expected.len(), len), "{}", text);
        prop_assert_eq!(found, expected, "{}", text);
    }

    #[test]
    fn eight_bytes_are_eight_digits_or_not(bytes in any::<[u8; 8]>(), digits in 0..100_000_000_u64) {
        let number = std::str::from_utf8(&bytes).ok().filter(|text| text.bytes().all(|byte| byte.is_ascii_digit()));
        prop_assert_eq!(eight_digits(bytes), number.map(|text| text.parse().expect("digits")));
        let text = format!("{digits:08}");
        prop_assert_eq!(text.as_bytes().first_chunk().copied().and_then(eight_digits), Some(digits));
    }
}

#[test]
fn what_is_usual_is_taken() {
    for (text, value) in [("0,", false), ("1]", true), ("false", false), ("true,", true)] {
        assert_eq!(bool::usual(text.as_bytes()), Some((value, text.trim_end_matches([',', ']']).len())), "{text}");
    }
    // A number ends at a byte that cannot be part of one, such as the neighbours of the digits.
    for text in ["7:", "7/"] {
        assert_eq!(
            (f64::usual(text.as_bytes()), i64::usual(text.as_bytes())),
            (Some((7.0, 1)), Some((7, 1))),
            "{text}"
        );
    }
    // The longest: 19 digits.
    assert_eq!(f64::usual(b"-1234567890.123456789,"), Some((-1_234_567_890.123_456_8, 21)));
    assert_eq!(f64::usual(b"1234567890123456789 "), Some((1_234_567_890_123_456_800.0, 19)));
}

#[test]
fn nothing_is_taken_that_goes_on() {
    for text in ["1", "-", "-,", "1e5,", "1.,", ".5,", "1.5", "01x", "1.5.2,", "1-2,", "12345678901234567890,"] {
        assert_eq!(f64::usual(text.as_bytes()), if text == "01x" { Some((1.0, 2)) } else { None }, "{text}");
    }
    for text in ["1", "-", "-,", "1e5,", "1.0,", "1234567890123456789,"] {
        assert_eq!(i64::usual(text.as_bytes()), None, "{text}");
    }
    for text in ["2,", "1", "10,", "1.0,", "\"1\",", "tru"] {
        assert_eq!(bool::usual(text.as_bytes()), None, "{text}");
    }
}
