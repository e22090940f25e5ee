//! What stands for a simulated clock where there is none.

use std::io;
use std::net::{Shutdown, TcpStream};
use std::sync::{Mutex, MutexGuard};
use std::time::{Duration, Instant};

/// A clock that does not exist.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum SimulatedClock {}

/// A thread that takes part in its time.
pub(crate) type Participant = SimulatedClock;

/// An end of a connection that takes part in its time.
pub(crate) type Channel = SimulatedClock;

impl SimulatedClock {
    pub(crate) fn now(&self) -> Instant {
        match *self {}
    }

    pub(crate) fn elapsed(&self) -> Duration {
        match *self {}
    }

    pub(crate) fn sleep(&self, _: Duration) {
        match *self {}
    }

    pub(crate) fn sleep_until(&self, _: Instant) {
        match *self {}
    }

    pub(crate) fn participant(&self) -> Participant {
        match *self {}
    }

    pub(crate) fn servant(&self) -> Participant {
        match *self {}
    }

    pub(crate) fn outside<T>(&self, _: impl FnOnce() -> T) -> T {
        match *self {}
    }

    pub(crate) fn notify_all(&self, _: usize) {
        match *self {}
    }

    pub(crate) fn wait_for<'m, T>(
        &self,
        _: usize,
        _: &'m Mutex<T>,
        _: MutexGuard<'m, T>,
        _: Option<Duration>,
    ) -> MutexGuard<'m, T> {
        match *self {}
    }

    pub(crate) fn connected(&self, _: &TcpStream) -> io::Result<Channel> {
        match *self {}
    }

    pub(crate) fn run<T>(self, _: impl FnOnce() -> T) -> T {
        match self {}
    }

    pub(crate) fn read(&self, _: &TcpStream, _: &mut [u8], _: Option<Duration>) -> io::Result<usize> {
        match *self {}
    }

    pub(crate) fn peek(&self, _: &TcpStream) -> io::Result<usize> {
        match *self {}
    }

    pub(crate) fn write(&self, _: &TcpStream, _: &[u8], _: Option<Duration>) -> io::Result<usize> {
        match *self {}
    }

    pub(crate) fn set_nonblocking(&self, _: bool) {
        match *self {}
    }

    pub(crate) fn shutdown(&self, _: &TcpStream, _: Shutdown) -> io::Result<()> {
        match *self {}
    }
}
