//! Limits of a field: the ends of a range, text, arrays, raw and absent values, and the words of a refusal.

use jaka_proto::FirmwareRange;
use jaka_proto::check::{AdvisoryRanges, FieldLimits, InvalidArgument, NotSent, Place, Rules, Standing, Validate};
use jaka_proto::wire::{Typed, Value};

const UP_TO_TEN: FieldLimits = FieldLimits { max: Some(10.0), unit: "mm", ..FieldLimits::NONE };
const ASCII: FieldLimits = FieldLimits { ascii: true, ..FieldLimits::NONE };

fn request(ranges: AdvisoryRanges) -> Place<'static> {
    Place::request("set_fan", ranges.into())
}

/// Returns the error for a field of this value; `None` if it may be sent.
fn invalid(value: &dyn Validate, limits: &FieldLimits, ranges: AdvisoryRanges) -> Option<InvalidArgument> {
    match request(ranges).check("fan", value, limits) {
        Ok(()) => None,
        Err(NotSent::InvalidArgument(invalid)) => Some(invalid),
        Err(other) => panic!("no firmware is known, yet {other:?}"),
    }
}

fn is_valid(value: &dyn Validate, limits: &FieldLimits) -> bool {
    invalid(value, limits, AdvisoryRanges::Enforced).is_none()
}

#[test]
fn the_ends_of_a_range_are_in_it() {
    let limits = FieldLimits { min: Some(-1.0), max: Some(1.0), ..FieldLimits::NONE };
    assert!(is_valid(&-1.0, &limits) && is_valid(&1.0, &limits) && is_valid(&1_i64, &limits));
    assert!(!is_valid(&-1.001, &limits) && !is_valid(&1.001, &limits) && !is_valid(&2_i64, &limits));
    assert!(is_valid(&-1e300, &UP_TO_TEN) && !is_valid(&10.5, &UP_TO_TEN));
    assert!(is_valid(&f64::MAX, &FieldLimits::NONE) && !is_valid(&f64::NAN, &FieldLimits::NONE));
}

#[test]
fn limits_in_words() {
    let range = FieldLimits { min: Some(0.0), max: Some(1.5), ..FieldLimits::NONE };
    assert_eq!(range.to_string(), "0 to 1.5");
    assert_eq!(FieldLimits { min: Some(2.0), ..FieldLimits::NONE }.to_string(), "at least 2");
    assert_eq!(UP_TO_TEN.to_string(), "at most 10 mm");
    assert_eq!(FieldLimits::NONE.to_string(), "a finite number");
    assert_eq!(FieldLimits { unit: "deg", ..FieldLimits::NONE }.to_string(), "a finite number (in deg)");
}

#[test]
fn an_advisory_range_can_be_ignored_but_takes_no_number_that_is_not_finite() {
    let limits = FieldLimits { advisory: true, ..UP_TO_TEN };
    let enforced = invalid(&11.0, &limits, AdvisoryRanges::Enforced).expect("it is above");
    assert_eq!((enforced.value.as_str(), enforced.allowed.as_str(), enforced.advisory), ("11", "at most 10 mm", true));
    assert_eq!(invalid(&11.0, &limits, AdvisoryRanges::Ignored), None);
    let infinite = invalid(&f64::INFINITY, &limits, AdvisoryRanges::Ignored).expect("it is not finite");
    assert!(!infinite.advisory);
    assert!(invalid(&11.0, &UP_TO_TEN, AdvisoryRanges::Ignored).is_some());
}

#[test]
fn text_is_limited_only_where_the_spec_says_so() {
    for text in ["", "pick up (2).jks", "~"] {
        assert!(is_valid(&text.to_owned(), &ASCII), "{text}");
    }
    for text in ["über", "a\tb", "a\u{7f}", "a\0"] {
        assert!(!is_valid(&text.to_owned(), &ASCII), "{text:?}");
        assert!(is_valid(&text.to_owned(), &FieldLimits::NONE), "{text:?}");
    }
}

#[test]
fn each_element_is_checked_and_named() {
    assert!(is_valid(&vec![1.0, 10.0], &UP_TO_TEN) && is_valid(&[1_i64, 10], &UP_TO_TEN));
    let list = invalid(&vec![vec![1.0], vec![2.0, 11.0]], &UP_TO_TEN, AdvisoryRanges::Enforced);
    assert_eq!(list.expect("one is above").field, "fan[1][1]");
    let array = invalid(&[1_i64, 2, 11], &UP_TO_TEN, AdvisoryRanges::Enforced);
    assert_eq!(array.expect("one is above").field, "fan[2]");
}

#[test]
fn what_is_absent_or_raw_is_not_checked() {
    assert!(is_valid(&None::<f64>, &UP_TO_TEN) && !is_valid(&Some(11.0), &UP_TO_TEN));
    assert!(is_valid(&Typed::<f64>::Raw(Value::from(11)), &UP_TO_TEN) && !is_valid(&Typed::Known(11.0), &UP_TO_TEN));
    assert!(is_valid(&Value::from(11), &UP_TO_TEN) && is_valid(&true, &UP_TO_TEN));
}

#[test]
fn an_absent_field_may_be_one_that_the_firmware_does_not_have() {
    let firmware = Some("1.5".parse().expect("it is a version"));
    let place = Place::request("set_fan", Rules { firmware, ..Rules::default() });
    let limits = FieldLimits { firmware: FirmwareRange::ALL.since([1, 6]), ..FieldLimits::NONE };
    assert_eq!(place.check("fan", &None::<f64>, &limits), Ok(()));
    for value in [&Some(1.0) as &dyn Validate, &1.0, &Typed::Known(1.0), &vec![1.0]] {
        assert!(matches!(place.check("fan", value, &limits), Err(NotSent::NotInFirmware(_))));
    }
}

#[test]
fn an_element_is_not_left_out_before_one_that_is_given() {
    let gap = |given: [bool; 3]| {
        let [a, b, c] = given;
        match request(AdvisoryRanges::Ignored).no_gap(&[("a", a), ("b", b), ("c", c)]) {
            Ok(()) => None,
            Err(NotSent::InvalidArgument(invalid)) => Some((invalid.field, invalid.advisory)),
            Err(other) => panic!("no firmware is known, yet {other:?}"),
        }
    };
    for whole in [[false; 3], [true, false, false], [true, true, false], [true; 3]] {
        assert_eq!(gap(whole), None, "{whole:?}");
    }
    assert_eq!(gap([false, true, false]), Some(("a".to_owned(), false)));
    assert_eq!(gap([true, false, true]), Some(("b".to_owned(), false)));
    assert_eq!(request(AdvisoryRanges::Enforced).no_gap(&[]), Ok(()));
}

#[test]
fn values_of_an_enum_by_their_standing() {
    let refused = |standing, ranges| match request(ranges).listed(&7, standing, "1 or 2") {
        Ok(()) => None,
        Err(NotSent::InvalidArgument(invalid)) => Some(invalid.advisory),
        Err(other) => panic!("no firmware is known, yet {other:?}"),
    };
    for (standing, enforced, ignored) in [
        (Standing::Listed, None, None),
        (Standing::Advisory, Some(true), None),
        (Standing::Unknown, Some(false), Some(false)),
    ] {
        assert_eq!(refused(standing, AdvisoryRanges::Enforced), enforced, "{standing:?}");
        assert_eq!(refused(standing, AdvisoryRanges::Ignored), ignored, "{standing:?}");
    }
}

#[test]
fn why_a_request_was_not_sent() {
    let invalid = InvalidArgument::new("set_fan", "speed", "11", "at most 10");
    let text = "`set_fan` was not sent: field `speed` is 11, allowed is at most 10";
    assert_eq!(NotSent::from(invalid.clone()).to_string(), text);
    let hint = "; this is advisory: `AdvisoryRanges::Ignored` leaves it to the controller";
    assert_eq!(NotSent::from(invalid.in_advisory_range()).to_string(), format!("{text}{hint}"));
    let firmware = Some("1.5".parse().expect("it is a version"));
    let place = Place::request("set_fan", Rules { firmware, ..Rules::default() });
    let limits = FieldLimits { firmware: FirmwareRange::ALL.since([1, 6]), ..FieldLimits::NONE };
    let missing = place.check("speed", &1.0, &limits).expect_err("the firmware is older");
    let NotSent::NotInFirmware(inner) = &missing else { panic!("the firmware is older, yet {missing:?}") };
    assert_eq!(missing.to_string(), inner.to_string());
    assert!(missing.to_string().contains("1.6"), "{missing}");
}
