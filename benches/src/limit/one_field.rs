//! The joint positions alone, out of a status packet whose braces have been matched.

use jaka_proto::messages::types::JointPosition;
use memchr::memmem;

use super::scan::Scan;

/// Looks for the key, and makes sure that it is one: of the packet itself, not of an object or a string inside.
pub fn joint_actual_position(packet: &str, finder: &memmem::Finder<'_>) -> Option<JointPosition> {
    let key = finder.find(packet.as_bytes())?;
    is_top_level(packet.as_bytes().get(..key)?).then_some(())?;
    let mut scan = Scan::new(packet.get(key + finder.needle().len()..)?);
    scan.blank();
    scan.array::<f64, 6>(Scan::float).map(Into::into)
}

/// True if one brace is open after these bytes, and no string.
fn is_top_level(bytes: &[u8]) -> bool {
    let mut depth = 0;
    let mut at = 0;
    while let Some(found) = bytes.get(at..).and_then(|rest| memchr::memchr3(b'"', b'{', b'}', rest)) {
        at += found + 1;
        match bytes[at - 1] {
            b'{' => depth += 1,
            b'}' => depth -= 1,
            _ => match string_end(&bytes[at..]) {
                Some(end) => at += end,
                None => return false,
            },
        }
    }
    depth == 1
}

fn string_end(bytes: &[u8]) -> Option<usize> {
    let mut at = 0;
    loop {
        at += memchr::memchr2(b'"', b'\\', bytes.get(at..)?)? + 1;
        if bytes[at - 1] == b'"' {
            return Some(at);
        }
        at += 1;
    }
}
