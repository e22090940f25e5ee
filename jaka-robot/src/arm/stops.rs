//! Stops by their numbers, and the motions that they keep back.

use std::time::Instant;

use crate::{Cause, Occurrence};

/// Stops that handles have requested, by their numbers from 1.
#[derive(Debug, Default)]
pub(crate) struct Stops {
    /// The latest requested stop.
    begun: u64,
    /// The latest that the controller has accepted.
    taken: u64,
    /// The latest that goes out, or has gone out: before that a servo session may brake.
    sent: u64,
    /// The latest that has been reported to the program.
    reported: u64,
    /// Number of stops on their way to the controller.
    under_way: u64,
    /// Time until which a servo session that moves the arm sends its next set-point; `None` if none moves it.
    set_point: Option<Instant>,
    /// Time at which the first stop that waits for a session to brake goes out at the latest; `None` if none waits.
    goes_out_at: Option<Instant>,
}

impl Stops {
    /// A stop begins, which goes out by then at the latest: its number.
    pub(super) fn begin(&mut self, latest: Instant) -> u64 {
        // A thread that sees the stop knows when it goes out.
        self.goes_out_at.get_or_insert(latest);
        self.under_way += 1;
        self.begun += 1;
        self.begun
    }

    /// The controller has answered a stop, or will not.
    pub(super) fn end(&mut self) {
        self.under_way -= 1;
    }

    /// Withdraws a stop, unless another was requested since.
    pub(super) fn take_back(&mut self, number: u64) {
        if self.begun == number {
            self.begun -= 1;
        }
    }

    /// A stop goes out.
    pub(super) fn send(&mut self, number: u64) {
        self.sent = self.sent.max(number);
    }

    /// The controller has accepted a stop.
    pub(super) fn take(&mut self, number: u64) {
        self.taken = self.taken.max(number);
    }

    /// The controller has not accepted a stop. A program that learned of it, or acknowledged it, did not know that.
    pub(super) fn fail(&mut self) {
        self.begun += 1;
    }

    /// Number of the latest stop that the controller has accepted.
    pub(crate) fn taken(&self) -> u64 {
        self.taken
    }

    /// Number of the latest stop that was asked for.
    pub(crate) fn begun(&self) -> u64 {
        self.begun
    }

    /// Number of the latest stop that has been reported to the program.
    pub(crate) fn reported(&self) -> u64 {
        self.reported
    }

    /// A stop that keeps motions back: one that is on its way, or one after the last that was reported to the program.
    /// `told` is the number of that one for a program with a lent arm.
    pub(super) fn pending(&self, told: Option<u64>) -> Option<Occurrence> {
        (self.is_under_way() || self.begun != told.unwrap_or(self.reported)).then(|| Cause::Stopped.into())
    }

    /// True while the controller has not answered a stop.
    pub(crate) fn is_under_way(&self) -> bool {
        self.under_way > 0
    }

    /// True if a stop has gone out, or is about to, that has not been reported to the program.
    pub(super) fn has_sent(&self, told: Option<u64>) -> bool {
        self.sent > told.unwrap_or(self.reported)
    }

    /// True if the controller has accepted a stop that has not been reported to the program.
    pub(crate) fn has_unreported(&self) -> bool {
        self.taken > self.reported
    }

    /// One stop is reported to the program. An unreported one before or after it keeps motions back as before.
    pub(crate) fn report(&mut self, number: u64) {
        if number == self.reported + 1 {
            self.reported = number;
        }
    }

    /// Marks the stops that the controller has accepted as reported to the program.
    pub(crate) fn report_taken(&mut self) {
        self.reported = self.reported.max(self.taken);
    }

    pub(super) fn acknowledge(&mut self) {
        self.reported = self.begun;
    }

    /// Sets when the next set-point of a session is due: true if stops that wait can go out.
    pub(super) fn expect_set_point(&mut self, due: Option<Instant>) -> bool {
        let was_expected = self.set_point.is_some();
        self.set_point = due;
        was_expected && due.is_none()
    }

    /// Time until which a stop waits for a session to brake; `None` without a wait.
    pub(super) fn waits_until(&self) -> Option<Instant> {
        Some(self.set_point?.min(self.goes_out_at?))
    }

    pub(super) fn goes_out_at(&self) -> Option<Instant> {
        self.goes_out_at
    }

    /// True while a servo session moves the arm.
    pub(super) fn expects_set_point(&self) -> bool {
        self.set_point.is_some()
    }

    pub(super) fn no_longer_waits(&mut self) {
        self.goes_out_at = None;
    }
}
