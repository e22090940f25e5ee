//! Actions on an arm that set-points lead.

/// Action on an arm at speed that set-points lead, by the cause of their end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Braking {
    /// Set-points brake and hold the arm: they still reach a controller that follows them, or may. A controller without
    /// power may follow them all the same, and refuses them otherwise; of an arm in drag mode the landing looks whether
    /// the joints follow; set-points of joints have no frame; a stop of the program goes out once the arm is braked.
    Land,
    /// No set-point goes out: none reaches the controller, or the controller follows none.
    Leave,
}
