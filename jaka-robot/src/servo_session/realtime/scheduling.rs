//! Scheduling of a thread by Linux.

use std::{fs, io};

use thread_priority::{
    Error, RealtimeThreadSchedulePolicy, ThreadPriority, ThreadSchedulePolicy, set_thread_priority_and_policy,
    thread_native_id, thread_schedule_policy_param,
};

use super::Restore;

/// Sets a real-time priority of this thread. Returns a restorer of its own scheduling; fails if that is impossible.
pub(super) fn set_realtime(priority: u8) -> io::Result<Restore> {
    let own = Scheduling::of_this_thread()?;
    let policy = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
    let priority = ThreadPriority::try_from(priority).map_err(io::Error::other)?;
    Scheduling { policy, priority }.set()?;
    Ok(Box::new(move || own.set()))
}

/// A policy, and the priority in it: of one without real-time priorities, the nice value.
struct Scheduling {
    policy: ThreadSchedulePolicy,
    priority: ThreadPriority,
}

impl Scheduling {
    /// Scheduling of this thread. Fails if it could not be set again.
    fn of_this_thread() -> io::Result<Self> {
        let (policy, parameters) = thread_schedule_policy_param(thread_native_id()).map_err(in_words)?;
        let number = match policy {
            ThreadSchedulePolicy::Normal(_) => nice_value()?,
            ThreadSchedulePolicy::Realtime(_) => parameters.sched_priority,
        };
        let priority = priority_of(policy, number)
            .ok_or_else(|| io::Error::new(io::ErrorKind::Unsupported, "its scheduling policy could not be restored"))?;
        Ok(Self { policy, priority })
    }

    /// Gives this thread the policy and the priority.
    fn set(&self) -> io::Result<()> {
        set_thread_priority_and_policy(thread_native_id(), self.priority, self.policy).map_err(in_words)
    }
}

/// The priority by the system's number. The crate has a scale of its own, and says which of its numbers is which of the
/// system's.
fn priority_of(policy: ThreadSchedulePolicy, number: i32) -> Option<ThreadPriority> {
    let mut priorities = (0..=99).filter_map(|priority| ThreadPriority::try_from(priority).ok());
    priorities.find(|priority| priority.to_posix(policy) == Ok(number))
}

/// The nice value of this thread: the 19th field of `/proc/…/stat`, whose second one may contain spaces, but ends with
/// a parenthesis.
fn nice_value() -> io::Result<i32> {
    let stat = fs::read_to_string("/proc/thread-self/stat")?;
    let nice = stat.rsplit(')').next().and_then(|fields| fields.split_whitespace().nth(16)?.parse().ok());
    nice.ok_or_else(|| io::Error::other("/proc/thread-self/stat does not say its nice value"))
}

fn in_words(error: Error) -> io::Error {
    match error {
        Error::OS(code) => io::Error::from_raw_os_error(code),
        other => io::Error::other(other),
    }
}

#[cfg(test)]
mod tests {
    use thread_priority::NormalThreadSchedulePolicy;

    use super::*;

    #[test]
    fn each_nice_value_and_each_priority_can_be_given_back() {
        for (policy, numbers) in [
            (ThreadSchedulePolicy::Normal(NormalThreadSchedulePolicy::Other), -20..=19),
            (ThreadSchedulePolicy::Normal(NormalThreadSchedulePolicy::Batch), -20..=19),
            (ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo), 1..=99),
            (ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::RoundRobin), 1..=99),
        ] {
            for number in numbers {
                let priority = priority_of(policy, number).unwrap_or_else(|| panic!("{policy:?} {number}"));
                assert_eq!(priority.to_posix(policy), Ok(number), "{policy:?}");
            }
        }
        assert_eq!(priority_of(ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Deadline), 0), None);
    }
}
