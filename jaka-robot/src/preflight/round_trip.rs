//! Round-trip time of queries.

use std::time::Duration;

use jaka_proto::messages::kinematics::GetJointPos;

use super::commands::Commands;
use super::finding::Judgement;

/// Number of queries that are measured, if they fit into the time.
const QUERIES: usize = 100;
const LONGEST: Duration = Duration::from_secs(2);

/// The controller's cycle: a set-point's reply after more time belongs to an earlier cycle.
const USUAL: Duration = Duration::from_millis(8);
/// Time for which set-points may be unanswered before a servo session ends ([`ServoConfig`](crate::ServoConfig)).
const RARE: Duration = Duration::from_millis(100);

/// Asks the same question many times.
pub(super) fn measure(commands: &mut Commands<'_>) -> Judgement {
    let clock = commands.clock();
    let since = clock.stopwatch();
    let mut times = Vec::with_capacity(QUERIES);
    while times.len() < QUERIES && (times.is_empty() || since.passed() < LONGEST) {
        let sent = clock.stopwatch();
        if let Err(failed) = commands.ask(&GetJointPos::new()) {
            return failed;
        }
        times.push(sent.passed());
    }
    judge(times)
}

fn judge(mut times: Vec<Duration>) -> Judgement {
    times.sort_unstable();
    let within = |percent: usize| times[(times.len() * percent).div_ceil(100).max(1) - 1];
    let (half, most) = (within(50), within(99));
    let seen = format!("{} queries: 50 % within {half:.1?}, 99 % within {most:.1?}", times.len());
    if half <= USUAL && most <= RARE {
        return Judgement::nothing(seen);
    }
    let advice = "connect by cable, without Wi-Fi and busy switches: set-points of servo mode are due each 8 ms, and a session ends when 100 ms of them are not answered";
    Judgement::look(seen, advice)
}

#[cfg(test)]
mod tests {
    use super::super::finding::Verdict;
    use super::*;

    /// The verdict on 100 times, of which some are slow.
    fn verdict(usual_ms: u64, slow: usize, slow_ms: u64) -> Verdict {
        let times = (0..QUERIES).map(|at| Duration::from_millis(if at < slow { slow_ms } else { usual_ms }));
        judge(times.collect()).verdict
    }

    #[test]
    fn one_slow_reply_of_a_hundred_is_nothing_and_two_are() {
        assert_eq!(verdict(8, 1, 5000), Verdict::NothingFound);
        assert_eq!(verdict(8, 2, 101), Verdict::Look);
        assert_eq!(verdict(8, 50, 100), Verdict::NothingFound);
        assert_eq!(verdict(8, 51, 9), Verdict::Look);
    }

    #[test]
    fn one_reply_is_enough_for_a_verdict() {
        assert_eq!(judge(vec![Duration::from_millis(1)]).verdict, Verdict::NothingFound);
        assert_eq!(judge(vec![Duration::from_secs(2)]).verdict, Verdict::Look);
    }
}
