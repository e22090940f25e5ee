//! Rest of the arm, by the controller's answers.

use std::time::{Duration, Instant};

use jaka_proto::messages::types::JointPosition;

/// Number of answers that show rest.
const COUNT: usize = 3;

/// Time between an answer and the next question.
pub(crate) const APART: Duration = Duration::from_millis(100);

/// Greatest speed of a joint of an arm at rest, in deg/s, unless [`RobotConfig`](crate::RobotConfig) sets another one.
/// Three answers with noise of 0.03 deg differ by up to 0.3 deg/s.
pub(crate) const REST_SPEED: f64 = 0.5;

/// Answer of the controller to a question for its joint positions.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TimedJoints {
    pub(crate) joints: JointPosition,
    /// Time at which the question was sent.
    pub(crate) asked: Instant,
    /// Time at which the answer was there. The joints were so at some time between the two.
    pub(crate) answered: Instant,
}

/// The last three answers: the one notion of rest. The arm is at rest if no joint turned faster over them than a
/// threshold.
#[derive(Debug)]
pub(crate) struct RestWindow {
    rest_speed: f64,
    answers: Vec<TimedJoints>,
}

/// Judgement of the last three answers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Seen {
    /// There are fewer than three.
    TooFew,
    /// No joint turned faster than the threshold.
    AtRest,
    /// A joint did, the fastest of which turned so.
    Turns(Turn),
}

/// Turn of a joint over three answers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Turn {
    /// The joint, 1 to 6.
    pub(crate) joint: usize,
    /// Difference between the greatest and the smallest of its positions, in degrees.
    pub(crate) by_deg: f64,
    /// Least time in which it turned so far: from the first answer to the last question.
    pub(crate) within: Duration,
}

impl RestWindow {
    pub(crate) fn new(rest_speed: f64) -> Self {
        Self { rest_speed, answers: Vec::with_capacity(COUNT) }
    }

    /// Takes the next answer, and judges the last three.
    pub(crate) fn take(&mut self, answer: TimedJoints) -> Seen {
        if self.answers.len() == COUNT {
            self.answers.remove(0);
        }
        self.answers.push(answer);
        let [first, _, last] = &self.answers[..] else { return Seen::TooFew };
        let within = last.asked.saturating_duration_since(first.answered);
        let turns = (0..6).map(|joint| Turn { joint: joint + 1, by_deg: self.spread(joint), within });
        // A position that is no number turns fastest.
        let Some(fastest) = turns.max_by(|one, other| one.by_deg.total_cmp(&other.by_deg)) else { return Seen::AtRest };
        if fastest.speed() <= self.rest_speed { Seen::AtRest } else { Seen::Turns(fastest) }
    }

    /// Forgets the answers, as a question was not answered.
    pub(crate) fn clear(&mut self) {
        self.answers.clear();
    }

    fn spread(&self, joint: usize) -> f64 {
        let positions = || self.answers.iter().map(|answer| answer.joints.0[joint]);
        let (greatest, smallest) = (positions().max_by(f64::total_cmp), positions().min_by(f64::total_cmp));
        greatest.zip(smallest).map_or(0.0, |(greatest, smallest)| (greatest - smallest).abs())
    }
}

impl Turn {
    /// Speed of the joint, in deg/s, which is at most this.
    pub(crate) fn speed(&self) -> f64 {
        if self.by_deg == 0.0 { 0.0 } else { self.by_deg / self.within.as_secs_f64() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Judgements of answers at a constant speed of joint 3, each of which comes after this time, from the third on.
    fn seen(speed: f64, latency: Duration, count: u32) -> Vec<Seen> {
        let (mut window, began) = (RestWindow::new(REST_SPEED), Instant::now());
        let mut judged: Vec<_> = (0..count)
            .map(|number| {
                let asked = began + (APART + latency) * number;
                // The joints are those of any time between question and answer: the worst is late first, early last.
                let at = if number == 0 { asked + latency } else { asked };
                let mut joints = [10.0; 6];
                joints[2] += speed * (at - began).as_secs_f64();
                window.take(TimedJoints { joints: JointPosition(joints), asked, answered: asked + latency })
            })
            .collect();
        assert_eq!(judged.drain(..2).collect::<Vec<_>>(), [Seen::TooFew; 2]);
        judged
    }

    #[test]
    fn an_arm_above_the_threshold_is_never_at_rest_and_one_below_it_always() {
        for latency in [0, 8, 54, 100, 2000].map(Duration::from_millis) {
            for speed in [0.51, 0.6, 2.0, 20.0, -0.6] {
                for seen in seen(speed, latency, 6) {
                    let Seen::Turns(turn) = seen else { panic!("{speed} deg/s is at rest, {latency:?}: {seen:?}") };
                    assert!(turn.joint == 3 && turn.speed() >= speed.abs() * 0.999, "{speed} deg/s: {turn:?}");
                }
            }
            assert_eq!(seen(0.0, latency, 6), [Seen::AtRest; 4]);
        }
        assert_eq!(seen(0.49, Duration::from_millis(8), 3), [Seen::AtRest]);
        let [Seen::Turns(turn)] = seen(2.0, Duration::ZERO, 3)[..] else { panic!("it turns at 2 deg/s") };
        assert!((turn.speed() - 2.0).abs() < 1e-9 && (turn.by_deg - 0.4).abs() < 1e-9, "{turn:?}");
        assert_eq!(turn.within, 2 * APART);
    }

    #[test]
    fn an_arm_that_comes_back_between_the_answers_is_not_at_rest() {
        let (mut window, began) = (RestWindow::new(REST_SPEED), Instant::now());
        let mut take = |millis: u64, first: f64| {
            let asked = began + Duration::from_millis(millis);
            window.take(TimedJoints { joints: JointPosition([first; 6]), asked, answered: asked })
        };
        assert_eq!([take(0, 0.0), take(100, 0.2)], [Seen::TooFew; 2]);
        assert!(matches!(take(200, 0.0), Seen::Turns(_)));
        // The window slides: rest is seen with the first three answers that show it.
        assert!(matches!(take(300, 0.0), Seen::Turns(_)));
        assert_eq!(take(400, 0.0), Seen::AtRest);
        assert!(matches!(take(500, f64::NAN), Seen::Turns(_)));
        window.clear();
    }
}
