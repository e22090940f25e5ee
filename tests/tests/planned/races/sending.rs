//! Many commands at once: they go out in pieces, so that a stop can go between.

use jaka_proto::check::{FieldLimits, NotSent, Place, Validate};
use jaka_proto::wire::{DecodeError, Fields, Reader, Writer};
use jaka_proto::{Command, CommandInfo};
use jaka_sync::io::SetDigitalOutput;
use jaka_sync::types::Switch;
use jaka_tests::{Arm, LONG};

/// More than this many bytes are never composed before those in front of them have gone out: a piece of about 4 KB.
const AHEAD: usize = 5000;

/// A command that is composed only once the controller has received those before it, up to [`AHEAD`].
struct Watched<'a> {
    arm: &'a Arm,
    index: usize,
    length: usize,
    inner: SetDigitalOutput,
}

impl Command for Watched<'_> {
    type Reply = ();
    const INFO: &'static CommandInfo = SetDigitalOutput::INFO;
}

impl Validate for Watched<'_> {
    fn validate(&self, place: &Place<'_>, limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        self.inner.validate(place, limits)
    }
}

impl Fields for Watched<'_> {
    fn write_fields(&self, out: &mut Writer) {
        let received = self.index.saturating_sub(AHEAD / self.length);
        assert!(self.arm.wait_for_requests(received, LONG), "{} commands are composed, and none sent", self.index);
        self.inner.write_fields(out);
    }

    fn read_fields(_reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Err(DecodeError::unfit("nothing", ""))
    }
}

#[test]
fn a_long_pipeline_goes_out_in_pieces() {
    let (arm, mut client) = super::arm().with_client();
    let output = || SetDigitalOutput::cabinet(1, Switch::On);
    let mut written = Writer::default();
    output().write_request(&mut written);
    let length = written.as_str().len();
    let commands: Vec<_> = (0..250).map(|index| Watched { arm: &arm, index, length, inner: output() }).collect();
    assert!(commands.len() * length > 2 * AHEAD, "it takes several pieces");
    let mut pipeline = client.pipeline(commands.len());
    pipeline.send_all(&commands).expect("there is room");
    assert_eq!(pipeline.finish().expect("all are accepted"), 250);
    assert_eq!(arm.requests().len(), 250);
}
