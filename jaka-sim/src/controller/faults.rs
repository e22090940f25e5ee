//! What a controller's owner has go wrong.

use std::io;

use super::Controller;
use crate::{Fault, StatusFault};

impl Controller {
    /// Puts a fault into the queue, from which each reply takes the next.
    pub fn inject(&self, fault: Fault) {
        self.shared.faults().script.push_back(fault);
    }

    /// Gives a fault to the next reply to this command, such as `joint_move`, that has none yet.
    ///
    /// That reply takes none from the queue of [`inject`](Self::inject).
    pub fn inject_for(&self, command: impl Into<String>, fault: Fault) {
        self.shared.faults().commands.push((command.into(), fault));
    }

    /// Gives a fault to all replies that have no other, from now on; [`Fault::None`] ends it.
    pub fn inject_always(&self, fault: Fault) {
        self.shared.faults().inject_always(fault);
    }

    /// Takes back all faults of replies to come, also those of the [`FaultPlan`](crate::FaultPlan).
    ///
    /// What is kept back already stays so, and so do the faults of the status port and of the links.
    pub fn clear_faults(&self) {
        self.shared.faults().clear();
    }

    /// Sets what is wrong with status packets from now on; [`StatusFault::None`] ends it.
    ///
    /// ```
    /// use jaka_sim::{Controller, StatusFault};
    ///
    /// let controller = Controller::start()?;
    /// controller.status_fault(StatusFault::Silent);
    /// // Here a monitor must say that it is blind.
    /// controller.status_fault(StatusFault::None);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    pub fn status_fault(&self, fault: StatusFault) {
        self.shared.status_listener.wait_until_accepted();
        self.shared.readers.set_fault(fault);
    }

    /// Sends the replies that are held back by [`Fault::Hold`], if the client is still connected, and has the other
    /// client of [`take_over`](Self::take_over) or [`Fault::Takeover`] leave.
    pub fn release(&self) {
        if let Some(connection) = self.shared.active_client.connection() {
            // A connection that is lost takes its replies with it.
            connection.writer().release().ok();
        }
        self.shared.active_client.disconnect_other();
    }

    /// Has another client take the command port: the connection of the present one is closed.
    ///
    /// The other client stays until a further client takes the port from it, or, if further clients are refused
    /// ([`Takeover::Refuse`](crate::Takeover::Refuse)), until [`release`](Self::release).
    ///
    /// # Errors
    /// The other client cannot connect.
    pub fn take_over(&self) -> io::Result<()> {
        self.shared.command_listener.wait_until_accepted();
        self.shared.take_over()?;
        self.shared.command_listener.wait_until_accepted();
        Ok(())
    }
}
