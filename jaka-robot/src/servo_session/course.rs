//! The last set-points of a session, by which the next one is checked, and after which the arm is braked.

use jaka_proto::messages::types::{JointPosition, Pose};

use super::set_point::turned;
use super::set_point::{SetPoint, SetPointStep};

/// The last set-points, in joints and in poses, as far as they are known.
#[derive(Debug, Clone)]
pub(crate) struct Course {
    joints: LastTwo,
    /// The last pose, where it is known.
    pose: Option<Pose>,
    /// The last one; none while nothing was sent.
    sent: Option<SetPoint>,
    /// Step from the set-point before to the last one, where it is known.
    step: Option<SetPointStep>,
}

/// The last but one and the last, where they are known.
#[derive(Debug, Clone, Copy)]
struct LastTwo {
    before: Option<JointPosition>,
    last: Option<JointPosition>,
}

impl LastTwo {
    const UNKNOWN: Self = Self { before: None, last: None };

    fn at(place: Option<JointPosition>) -> Self {
        Self { before: place, last: place }
    }

    fn then(self, next: Option<JointPosition>) -> Self {
        Self { before: self.last, last: next }
    }

    fn both(self) -> Option<[JointPosition; 2]> {
        Some([self.before?, self.last?])
    }
}

impl Course {
    /// Of a session that has not begun.
    pub(super) fn unknown() -> Self {
        Self { joints: LastTwo::UNKNOWN, pose: None, sent: None, step: None }
    }

    /// Of a session that begins at rest here.
    pub(super) fn at(joints: JointPosition, pose: Option<Pose>) -> Self {
        Self { joints: LastTwo::at(Some(joints)), pose, sent: None, step: None }
    }

    /// The last two set-points, in joint positions, where they are known.
    pub(crate) fn last_joints(&self) -> Option<[JointPosition; 2]> {
        self.joints.both()
    }

    /// Joint positions of the last set-point, if it is one of joints, and they are known.
    pub(super) fn held_joints(&self) -> Option<JointPosition> {
        let of_joints = matches!(self.sent, Some(SetPoint::Joints(_) | SetPoint::JointOffset(_)));
        self.joints.last.filter(|_| of_joints)
    }

    /// Joint positions of a set-point, as far as it says them itself.
    pub(super) fn joints_at(&self, next: &SetPoint) -> Option<JointPosition> {
        match next {
            SetPoint::Joints(target) => Some(*target),
            SetPoint::JointOffset(offset) => self.joints.last.map(|last| moved(last, &offset.0)),
            SetPoint::Pose(_) | SetPoint::PoseOffset(_) => None,
        }
    }

    /// Step from the last set-point to this one, where it is known.
    pub(super) fn step_to(&self, next: &SetPoint) -> Option<SetPointStep> {
        match next {
            SetPoint::Joints(target) => self.joints.last.map(|last| SetPointStep::between_joints(last, *target)),
            SetPoint::JointOffset(offset) => Some(SetPointStep::Joints(offset.0)),
            SetPoint::Pose(target) => self.pose.map(|last| SetPointStep::between_poses(last, *target)),
            // The angles are taken as a turn, which they are where they are small.
            SetPoint::PoseOffset(offset) => Some(SetPointStep::Pose((*offset).into())),
        }
    }

    /// Step from the set-point before to the last one, of the same kind as `like`; `None` if it is not known.
    pub(super) fn last_step(&self, like: &SetPointStep) -> Option<SetPointStep> {
        match (self.step, like) {
            (None, like) if self.sent.is_none() => Some(like.scaled(0.0)),
            // A stationary arm is stationary in joints and in poses.
            (Some(step), like) if step.is_none() => Some(like.scaled(0.0)),
            (Some(step @ SetPointStep::Joints(_)), SetPointStep::Joints(_))
            | (Some(step @ SetPointStep::Pose(_)), SetPointStep::Pose(_)) => Some(step),
            (_, SetPointStep::Joints(_)) => {
                self.joints.both().map(|[before, last]| SetPointStep::between_joints(before, last))
            }
            _ => None,
        }
    }

    /// A set-point was sent, at which the joints are here, where that is known.
    pub(super) fn sent(&mut self, set_point: SetPoint, joints: Option<JointPosition>) {
        self.step = self.step_to(&set_point);
        self.joints = self.joints.then(joints);
        self.pose = if let SetPoint::Pose(target) = set_point { Some(target) } else { None };
        self.sent = Some(set_point);
    }

    /// The next set-points are in joints, where these are known.
    pub(super) fn go_on_in_joints(&mut self) {
        if let (Some(SetPoint::Pose(_)), Some([before, last])) = (self.sent, self.joints.both()) {
            (self.sent, self.step) = (Some(SetPoint::Joints(last)), Some(SetPointStep::between_joints(before, last)));
        }
    }

    /// No set-point came when one was due: the arm stands at the last one.
    pub(super) fn paused(&mut self) {
        self.joints = LastTwo::at(self.joints.last);
        self.step = self.sent.map(|_| SetPointStep::Joints([0.0; 6]));
    }

    /// A reply was lost: where offsets have led is not known. After one of a pose no place is known in any case.
    pub(super) fn lost(&mut self) {
        if let Some(SetPoint::JointOffset(_)) = self.sent {
            self.joints = LastTwo::UNKNOWN;
        }
    }

    /// True if a set-point was sent, and the last one asks for a motion.
    pub(super) fn is_moving(&self) -> bool {
        self.sent.is_some() && self.step.is_none_or(|step| !step.is_none())
    }

    /// True if a set-point was sent.
    pub(super) fn has_begun(&self) -> bool {
        self.sent.is_some()
    }

    /// The step from the last set-point but one to the last, from which the arm is braked; `None` if it stands, or
    /// that is not known.
    pub(super) fn step(&self) -> Option<SetPointStep> {
        self.step.filter(|step| !step.is_none())
    }

    /// The step to the last set-point, in joints where these are known; `None` if the step is not known.
    pub(super) fn step_of_joints(&self) -> Option<SetPointStep> {
        self.joints.both().map(|[before, last]| SetPointStep::between_joints(before, last)).or(self.step)
    }

    /// The set-point this far from the last one, of the same kind as that.
    pub(super) fn after(&self, step: &SetPointStep) -> Option<SetPoint> {
        match (self.sent?, step) {
            (SetPoint::Joints(last), SetPointStep::Joints(step)) => Some(SetPoint::Joints(moved(last, step))),
            (SetPoint::JointOffset(_), SetPointStep::Joints(step)) => Some(SetPoint::JointOffset(JointPosition(*step))),
            (SetPoint::Pose(last), SetPointStep::Pose([x, y, z, rx, ry, rz])) => {
                let moved = Pose { x: last.x + x, y: last.y + y, z: last.z + z, ..last };
                Some(SetPoint::Pose(turned(moved, [*rx, *ry, *rz])))
            }
            (SetPoint::PoseOffset(_), SetPointStep::Pose(step)) => Some(SetPoint::PoseOffset(Pose::from(*step))),
            _ => None,
        }
    }

    /// The last set-point once more, which holds the arm there.
    pub(super) fn hold(&self) -> Option<SetPoint> {
        Some(match self.sent? {
            SetPoint::JointOffset(_) => SetPoint::JointOffset(JointPosition([0.0; 6])),
            SetPoint::PoseOffset(_) => SetPoint::PoseOffset(Pose::from([0.0; 6])),
            absolute => absolute,
        })
    }
}

fn moved(from: JointPosition, by: &[f64; 6]) -> JointPosition {
    JointPosition(std::array::from_fn(|joint| from.0[joint] + by[joint]))
}
