//! Requests, as a controller reads them.

use jaka_proto::check::{AdvisoryRanges, Rules};
use jaka_proto::wire::Writer;
use jaka_proto::{FirmwareVersion, Request};

/// A request that was read comes back when it is written and read again. What is allowed is so by more lenient rules,
/// too.
///
/// # Panics
/// One of these is not so.
pub fn requests(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let Ok(request) = Request::read(text).inspect_err(|error| drop(error.to_string())) else { return };
    let written = write(&request);
    let again = Request::read(&written).unwrap_or_else(|error| panic!("{error}: {written}"));
    assert_eq!(again, request, "{written}");
    assert_eq!(write(&again), written);
    let is_allowed = |rules: Rules| request.check(rules).inspect_err(|error| drop(error.to_string())).is_ok();
    let lenient = Rules::from(AdvisoryRanges::Ignored);
    let strict = Rules { ranges: AdvisoryRanges::Enforced, firmware: Some(FirmwareVersion::new([1, 5, 14])) };
    assert!(!is_allowed(strict) || is_allowed(lenient), "{written}");
}

fn write(request: &Request) -> String {
    let mut out = Writer::new();
    request.write(&mut out);
    out.into_string()
}
