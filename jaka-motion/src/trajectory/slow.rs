//! Places at which a trajectory is slower than requested.

/// Place at which the tool is slower than the requested speed, between two others at which it is faster.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct SlowPlace {
    /// Trajectory time, in seconds.
    pub time_s: f64,
    /// Share of the requested speed of the tool centre point.
    pub share: f64,
    /// Limit that allows no higher speed there.
    pub by: SlowedBy,
}

jaka_proto::worded! {
    /// Limit that slows a trajectory down, and the joint, 1 to 6, for a limit of a joint.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize), serde(tag = "kind", rename_all = "snake_case"))]
    #[non_exhaustive]
    pub enum SlowedBy {
        /// Speed of a joint.
        Speed {
            /// Number of the joint.
            joint: usize,
        } => "the speed of joint {joint}",
        /// Acceleration of a joint, without the reserve on bends of the path.
        Acceleration {
            /// Number of the joint.
            joint: usize,
        } => "the acceleration of joint {joint}",
        /// Jerk of a joint.
        Jerk {
            /// Number of the joint.
            joint: usize,
        } => "the jerk of joint {joint}",
        /// Acceleration of the tool centre point along its path.
        ToolAcceleration => "the acceleration of the tool",
    }
}

/// Share from which a place is not slow.
const FAST: f64 = 0.97;
/// Greatest number of slow places that are kept.
const MOST: usize = 20;

impl SlowPlace {
    /// Returns the slowest places between two stops: the minima of the speed. If there are none, it returns the fastest
    /// place, with the limit that applies at most of the places.
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

    /// Returns the slowest places, the slowest first.
    pub(super) fn sorted(mut all: Vec<Self>) -> Vec<Self> {
        all.sort_by(|one, other| one.share.total_cmp(&other.share));
        all.truncate(MOST);
        all
    }
}

impl SlowedBy {
    /// Returns the limit of which the largest share is used, from the shares of speeds, accelerations and jerks, and of
    /// the tool's acceleration.
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
