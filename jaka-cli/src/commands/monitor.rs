//! `jaka monitor`: a live dashboard in the terminal.

pub(crate) mod dashboard;

use std::io::{self, IsTerminal, stderr, stdin, stdout};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use clap::Args;
use jaka_sync::Reconnect;
use ratatui::DefaultTerminal;
use ratatui::crossterm::event::{self, Event};

use crate::arm::interrupt::on_interrupt;
use crate::commands::monitor::dashboard::{Feed, View, draw};
use crate::failure::Failure;
use crate::target::RobotArgs;
use crate::target::packs::SpecArgs;
use crate::terminal::logging;

/// Interval of screen updates; each key updates it, too.
const TICK: Duration = Duration::from_millis(100);

/// Policy for reconnecting: a short pause first, then longer ones.
const RECONNECT: Reconnect =
    Reconnect::Attempts { limit: u32::MAX, delay: Duration::from_millis(250), longest: Duration::from_secs(2) };

/// Show the robot's state live in the terminal.
///
/// Reads only the status port, so that it disturbs no other program. Reconnects after a lost connection.
#[derive(Debug, Args)]
pub(crate) struct Monitor {
    #[command(flatten)]
    spec: SpecArgs,
    #[command(flatten)]
    robot: RobotArgs,
}

impl Monitor {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if !stdin().is_terminal() || !stdout().is_terminal() {
            return Err(Failure::Usage("`jaka monitor` needs a terminal; `jaka status --watch` does not".to_owned()));
        }
        if logging::is_told() && stderr().is_terminal() {
            return Err(Failure::Usage("`jaka monitor -v` needs standard error in a file: `2> log.txt`".to_owned()));
        }
        let protocol = self.spec.load(self.robot.lookup())?;
        let target = self.robot.target(&protocol.packs)?;
        protocol.read_status();
        let mut feed = Feed::new(target.monitor(RECONNECT)?);
        let mut view = View::new(target.title());
        let ended = Arc::new(AtomicBool::new(false));
        let end = Arc::clone(&ended);
        // Without the terminal, the wait for keys never ends, and `on_interrupt` ends the program.
        on_interrupt(move || end.store(true, Ordering::Relaxed));
        // This also makes a panic restore the terminal.
        let mut terminal = ratatui::try_init().map_err(no_terminal)?;
        let result = watch(&mut terminal, &mut feed, &mut view, &ended);
        let restored = ratatui::try_restore();
        result.and(restored).map_err(no_terminal)
    }
}

fn watch(terminal: &mut DefaultTerminal, feed: &mut Feed, view: &mut View, ended: &AtomicBool) -> io::Result<()> {
    while !ended.load(Ordering::Relaxed) {
        feed.update(view);
        let mut most = 0;
        terminal.draw(|frame| most = draw(frame, view))?;
        view.scroll_at_most(most);
        if !event::poll(TICK)? {
            continue;
        }
        // All other events, such as a new size, only need an update of the screen.
        if let Event::Key(key) = event::read()?
            && view.ends_after(key)
        {
            break;
        }
    }
    Ok(())
}

fn no_terminal(error: io::Error) -> Failure {
    Failure::local("the terminal cannot be used", error)
}
