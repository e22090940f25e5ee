//! Points of the arm.

jaka_proto::worded! {
    /// A point of the arm.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Point {
        /// The tool centre point.
        Tcp => "tool centre point",
        /// The end of the upper arm, on the axis of joint 3: the third of
        /// [`Model::joint_frames`](crate::Model::joint_frames).
        Elbow => "elbow",
        /// Where the axes of joints 5 and 6 meet: the fifth of [`Model::joint_frames`](crate::Model::joint_frames).
        Wrist => "wrist",
    }
}

impl Point {
    /// All points, in the order of their numbers.
    pub(crate) const ALL: [Self; 3] = [Self::Tcp, Self::Elbow, Self::Wrist];

    /// Index of the joint frame that has the point; that of the tool centre point but for the tool.
    pub(crate) fn frame(self) -> usize {
        match self {
            Self::Tcp => 5,
            Self::Elbow => 2,
            Self::Wrist => 4,
        }
    }
}
