//! Places at which a trajectory is slower than was asked for.

/// Place at which the tool is slower than the speed that was asked for, between two others at which it is faster.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct SlowPlace {
    /// Trajectory time, in seconds.
    pub time_s: f64,
    /// Share of the speed of the tool centre point that was asked for.
    pub share: f64,
    /// Limit that allows no more there.
    pub by: SlowedBy,
}

jaka_proto::worded! {
    /// Limit that slows a trajectory down, and the joint, 1 to 6, to which it applies, if it is one of a joint.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize), serde(tag = "kind", rename_all = "snake_case"))]
    #[non_exhaustive]
    pub enum SlowedBy {
        /// The speed of a joint.
        Speed {
            /// Its number.
            joint: usize,
        } => "the speed of joint {joint}",
        /// The acceleration of a joint, without the reserve where the way bends.
        Acceleration {
            /// Its number.
            joint: usize,
        } => "the acceleration of joint {joint}",
        /// The jerk of a joint.
        Jerk {
            /// Its number.
            joint: usize,
        } => "the jerk of joint {joint}",
        /// The acceleration of the tool centre point along its way.
        ToolAcceleration => "the acceleration of the tool",
    }
}

/// Shares of this and more are not slow.
const FAST: f64 = 0.97;
/// Most slow places that are kept.
const MOST: usize = 20;

impl SlowPlace {
    /// The slowest of places along a stretch from stop to stop: those at which the speed rises to both sides. If there
    /// are none, its fastest one, with the limit that holds most of the places.
    pub(super) fn slowest(all: &[Self]) -> Vec<Self> {
        let is_lowest =
            |index: &usize| all[*index].share < all[index - 1].share && all[*index].share <= all[index + 1].share;
        let mut found: Vec<_> = (1..all.len().saturating_sub(1)).filter(is_lowest).map(|index| all[index]).collect();
        if found.is_empty() {
            let mut counts: Vec<(SlowedBy, usize)> = Vec::new();
            for place in all {
                match counts.iter_mut().find(|(by, _)| *by == place.by) {
                    Some((_, count)) => *count += 1,
                    None => counts.push((place.by, 1)),
                }
            }
            let by = counts.into_iter().max_by_key(|(_, count)| *count).map(|(by, _)| by);
            let fastest = all.iter().max_by(|one, other| one.share.total_cmp(&other.share));
            found.extend(fastest.zip(by).map(|(fastest, by)| Self { by, ..*fastest }));
        }
        found.retain(|place| place.share < FAST);
        found
    }

    /// The first of all, the slowest first.
    pub(super) fn sorted(mut all: Vec<Self>) -> Vec<Self> {
        all.sort_by(|one, other| one.share.total_cmp(&other.share));
        all.truncate(MOST);
        all
    }
}

impl SlowedBy {
    /// The limit of which the largest share is used, by the shares of speeds, accelerations and jerks, and of the
    /// tool's acceleration.
    pub(super) fn of(shares: [[f64; 6]; 3], tool: f64) -> Self {
        let all = shares.into_iter().enumerate().flat_map(|(which, joints)| {
            joints.into_iter().enumerate().map(move |(joint, share)| (which, joint + 1, share))
        });
        let most = all.max_by(|one, other| one.2.total_cmp(&other.2));
        match most {
            Some((.., share)) if tool > share => Self::ToolAcceleration,
            Some((1, joint, _)) => Self::Acceleration { joint },
            Some((2, joint, _)) => Self::Jerk { joint },
            Some((_, joint, _)) => Self::Speed { joint },
            None => Self::Speed { joint: 1 },
        }
    }
}
