//! Curves through dense points.

use jaka_proto::messages::types::JointPosition;

use super::curve_path::{Begin, CurvePath, Lost, Nearness, Space, TURN_UNITS, distance, of_joints, of_tool};
use super::leg::{Leg, LegPath, SpeedSettings, TOLERANCES, Tolerances};
use super::path::Path;
use super::smoothing::{Place, Spline};
use super::through::{at_point, start};
use super::timing::{Timed, timed};
use super::via::{Via, ViaTarget};
use super::{Trajectory, TrajectoryError};
use crate::beyond::Exceeded;
use crate::checker::Checker;

/// Curve near dense points, to be built within an arm's limits. Made by [`Trajectory::curve`].
///
/// The points are joint positions, or joint positions and then poses of the tool in the user frame. The curve starts at
/// the first and ends at the last, at rest. It is the smoothest one within the tolerance of each point and of the
/// straight lines between them. Its second derivative is continuous, so a taught or sampled path is passed at the
/// requested speed. Points nearer to each other than a millionth of a degree or millimetre count as one.
///
/// A corner is a bend by more than [`corner_above_deg`](Self::corner_above_deg), or a bend between lines that are too
/// long for a curve within the tolerance. It is rounded as a corner of [`Trajectory::through`].
///
/// # Timing
/// The speed along the whole curve is the quickest within limits, as for [`Through`](crate::Through).
#[derive(Debug, Clone, PartialEq)]
#[must_use = "nothing is planned before it is built"]
pub struct Curve {
    points: Vec<Via>,
    near: Option<JointPosition>,
    tolerances: Tolerances,
    /// Tolerances for corners; `None` for those of the curve.
    corner_mm: Option<f64>,
    corner_deg: Option<f64>,
    corner_above_deg: f64,
    speeds: SpeedSettings,
}

/// Points of a curve in one space.
struct Given<'c> {
    curve: &'c Curve,
    checker: &'c Checker,
    space: Space,
    start: JointPosition,
    /// Distinct places, in their order.
    places: Vec<Place>,
    /// Index of the place of each point.
    place_of: Vec<usize>,
}

/// Part of a curve between two corners.
struct Section<'g> {
    given: &'g Given<'g>,
    from: usize,
    to: usize,
    /// Share of the tolerance for this section.
    share: f64,
    /// Number of parts of each line between two places.
    parts: Vec<usize>,
}

/// Default tolerance for the turn of the tool away from points, in degrees.
const TURN_DEG: f64 = 1.0;
/// Default angle of a bend above which it is a corner, in degrees.
const CORNER_ABOVE_DEG: f64 = 30.0;
/// Distance below which two points are one, in degrees or mm.
const SAME: f64 = 1e-6;
/// Share of a tolerance for the spline; the rest is for polynomials near it.
const OF_SPLINE: f64 = 0.9;
/// Share of a tolerance for the spline at its greatest distance between nodes.
const OF_WAYS: f64 = 0.94;
/// Share of a tolerance for the distance of polynomials of joints from the spline, and the greatest distance, in mm or
/// degrees.
const OF_POLYNOMIALS: f64 = 0.05;
const MOST_OFF: f64 = 0.005;
/// Length, in tolerances, of the lines that give the directions at a point.
const SPAN: f64 = 10.0;
/// Distance of a bend's arc from the straight lines, in tolerances, above which the bend is a corner.
const FAR_ARC: f64 = 2.0;
/// Distance of the arc of a bend from the parts of a line, in tolerances, that sets the number of parts.
const NEAR_ARC: f64 = 0.05;
/// Greatest number of parts of a line between two places, before and after refinement.
const MOST_PARTS: [usize; 2] = [16, 32];

impl Curve {
    pub(super) fn new(points: Vec<Via>) -> Self {
        let unset = Tolerances { mm: 0.0, turn_deg: TURN_DEG, joint_deg: 0.0 };
        Self {
            points,
            near: None,
            tolerances: unset,
            corner_mm: None,
            corner_deg: None,
            corner_above_deg: CORNER_ABOVE_DEG,
            speeds: SpeedSettings::default(),
        }
    }

    /// Sets joint positions near the start, such as those of the arm, for a first point that is a pose. The trajectory
    /// starts at the joint positions for this pose that are, of all branches, nearest to these.
    pub fn near(mut self, joints: impl Into<JointPosition>) -> Self {
        self.near = Some(joints.into());
        self
    }

    /// Sets the tolerance around the points and the straight lines between them, in millimetres. Required for poses.
    pub fn within_mm(mut self, tolerance: f64) -> Self {
        self.tolerances.mm = tolerance;
        self
    }

    /// Sets the tolerance in degrees: of each joint for joint positions, where it is required, and of the tool's turn
    /// for poses, where it is 1 by default.
    pub fn within_deg(mut self, tolerance: f64) -> Self {
        (self.tolerances.turn_deg, self.tolerances.joint_deg) = (tolerance, tolerance);
        self
    }

    /// Sets the angle, in degrees up to 180, above which a bend is a corner; 30 by default.
    pub fn corner_above_deg(mut self, angle: f64) -> Self {
        self.corner_above_deg = angle;
        self
    }

    /// Sets the tolerance, in millimetres, for rounded corners of a curve of the tool; 0 for a stop there. The default
    /// is the tolerance of the curve.
    pub fn corner_mm(mut self, tolerance: f64) -> Self {
        self.corner_mm = Some(tolerance);
        self
    }

    /// Sets the tolerance for rounded corners, in degrees of each joint or of the tool's turn; 0 for a stop there. The
    /// default is the tolerance of the curve.
    pub fn corner_deg(mut self, tolerance: f64) -> Self {
        self.corner_deg = Some(tolerance);
        self
    }

    /// Sets the highest speed of the tool centre point, in mm/s. A lower speed of the limits takes precedence.
    pub fn tcp_speed(mut self, mm_s: f64) -> Self {
        self.speeds.speeds.tcp_speed = mm_s;
        self
    }

    /// Sets the highest speeds of joints 1 to 6, in deg/s. Lower speeds of the limits take precedence.
    pub fn joint_speeds(mut self, deg_s: [f64; 6]) -> Self {
        self.speeds.speeds.joint_speeds = deg_s;
        self
    }

    /// Sets the highest jerks of joints 1 to 6, in deg/s³ from 0.001 to 1e9; they replace those of the limits.
    pub fn jerks(mut self, deg_s3: [f64; 6]) -> Self {
        self.speeds.jerks = Some(deg_s3);
        self
    }

    /// Sets the share of each joint's acceleration, from 0 to 0.9, that bends of the curve leave for a pause or another
    /// rate; 0.2 by default.
    pub fn reserve(mut self, share: f64) -> Self {
        self.speeds.reserve = share;
        self
    }

    /// Plans the trajectory, and compares it with an arm's limits.
    ///
    /// # Errors
    /// Invalid points or settings, or a place that is beyond a limit.
    pub fn build(&self, checker: &Checker) -> Result<Trajectory, TrajectoryError> {
        let given = Given::new(self, checker)?;
        self.tolerances.check(["within_mm", "within_deg", "within_deg"])?;
        let corners = self.corner_tolerances();
        corners.check(["corner_mm", "corner_deg", "corner_deg"])?;
        self.speeds.check()?;
        let Tolerances { mm, turn_deg, joint_deg } = self.tolerances;
        let needed = match given.space {
            Space::Joints => vec![("within_deg", joint_deg)],
            Space::Tool => vec![("within_mm", mm), ("within_deg", turn_deg)],
        };
        if let Some((what, given)) = needed.into_iter().find(|(_, given)| !TOLERANCES.contains(given)) {
            return Err(TrajectoryError::Setting { what, given, expected: "at least 0.001" });
        }
        if !(self.corner_above_deg > 0.0 && self.corner_above_deg <= 180.0) {
            let given = self.corner_above_deg;
            return Err(TrajectoryError::Setting {
                what: "corner_above_deg",
                given,
                expected: "above 0 and at most 180",
            });
        }
        let beside_corners = self.share_beside(given.space, &corners);
        let legs = given.legs(beside_corners)?;
        // The distance of a corner adds to that of its curve from the lines.
        let left = |corner: f64, tolerance: f64| (corner - beside_corners * tolerance).max(0.0);
        let corners = Tolerances {
            mm: left(corners.mm, mm),
            turn_deg: left(corners.turn_deg, turn_deg),
            joint_deg: left(corners.joint_deg, joint_deg),
        };
        let legs: Vec<_> = legs.into_iter().map(|leg| Leg { corner: corners, ..leg }).collect();
        let path = Path::of_legs(&legs, checker)?;
        let Timed { pieces, passages, slow } = timed(&path, &self.speeds.budget(checker), checker)?;
        let way_points = given.place_of.iter().map(|place| passages[*place]).collect();
        Trajectory::checked((pieces, way_points, slow), checker)
    }

    /// Returns the share of the tolerance for curves next to corners: at most half of the corners' tolerance, all of it
    /// next to stops.
    fn share_beside(&self, space: Space, corners: &Tolerances) -> f64 {
        let least = match space {
            Space::Joints => corners.joint_deg / self.tolerances.joint_deg,
            Space::Tool => (corners.mm / self.tolerances.mm).min(corners.turn_deg / self.tolerances.turn_deg),
        };
        if least > 0.0 { 0.5 * least.min(1.0) } else { 1.0 }
    }

    fn corner_tolerances(&self) -> Tolerances {
        let Tolerances { mm, turn_deg, joint_deg } = self.tolerances;
        Tolerances {
            mm: self.corner_mm.unwrap_or(mm),
            turn_deg: self.corner_deg.unwrap_or(turn_deg),
            joint_deg: self.corner_deg.unwrap_or(joint_deg),
        }
    }
}

impl<'c> Given<'c> {
    fn new(curve: &'c Curve, checker: &'c Checker) -> Result<Self, TrajectoryError> {
        let (start, rest) = start(&curve.points, curve.near, checker)?;
        let is_of_tool = matches!(rest, [Via { target: ViaTarget::Line(_), .. }, ..]);
        let (space, first) = if is_of_tool {
            (Space::Tool, of_tool(&checker.arm().tcp(&start.0), None))
        } else {
            (Space::Joints, of_joints(&start.0))
        };
        let mut made = Self { curve, checker, space, start, places: vec![first], place_of: vec![0] };
        for (way_point, via) in (2..).zip(rest) {
            let before = &made.places[made.places.len() - 1];
            if !via.is_plain() {
                return Err(TrajectoryError::OnCurve { way_point });
            }
            let place = match (via.target, space) {
                (ViaTarget::Joints(joints), Space::Joints) => {
                    checker.check_place(joints).map_err(|beyond| at_point(way_point, beyond))?;
                    of_joints(&joints.0)
                }
                (ViaTarget::Line(pose), Space::Tool) => of_tool(&checker.in_base(pose), Some(before)),
                _ => return Err(TrajectoryError::Mixed { way_point }),
            };
            if !place.iter().all(|number| number.is_finite()) {
                return Err(TrajectoryError::NotFinite { way_point, what: "position" });
            }
            if distance(before, &place) > SAME {
                made.places.push(place);
            }
            made.place_of.push(made.places.len() - 1);
        }
        if made.places.len() < 2 {
            return Err(TrajectoryError::NoWay);
        }
        Ok(made)
    }

    /// Returns the largest share of its tolerance that a difference takes.
    fn off(&self, off: &Place) -> f64 {
        let Tolerances { mm, turn_deg, joint_deg } = self.curve.tolerances;
        match self.space {
            Space::Joints => off.iter().fold(0.0, |most: f64, off| most.max(off.abs())) / joint_deg,
            Space::Tool => {
                let length = |off: &[f64]| off.iter().map(|off| off * off).sum::<f64>().sqrt();
                let turned = length(&off[3..]) * 2.0 / TURN_UNITS;
                (length(&off[..3]) / mm).max(turned.to_degrees() / turn_deg)
            }
        }
    }

    fn between(&self, from: usize, to: usize) -> Place {
        std::array::from_fn(|which| self.places[to][which] - self.places[from][which])
    }

    /// Returns the legs between corners, with a share of the tolerance next to corners.
    fn legs(&self, beside_corners: f64) -> Result<Vec<Leg>, TrajectoryError> {
        let start =
            self.checker.arm().at_joints(&self.start.0).ok_or_else(|| TrajectoryError::lost(1, self.checker))?;
        let distances = self.checker.signed_distances(&start.joints);
        let mut begin = Begin { checker: self.checker, start, distances };
        let mut corners = self.corners();
        corners.push(self.places.len() - 1);
        let (mut legs, mut from) = (Vec::with_capacity(corners.len()), 0);
        while let Some(to) = corners.iter().find(|corner| **corner > from).copied() {
            let is_whole = from == 0 && to == self.places.len() - 1;
            let mut section = Section::new(self, [from, to], if is_whole { 1.0 } else { beside_corners });
            match section.spline() {
                Ok(spline) => {
                    legs.push(section.leg(&spline, &mut begin)?);
                    from = to;
                }
                Err(more) => {
                    corners.extend(more);
                    corners.sort_unstable();
                    corners.dedup();
                }
            }
        }
        Ok(legs)
    }

    /// Returns the places at which the path bends by more than a curve may.
    fn corners(&self) -> Vec<usize> {
        let last = self.places.len() - 1;
        let (mut corners, mut best, mut group) = (Vec::new(), None::<(usize, f64)>, 0);
        let (mut back, mut ahead) = (0, 0);
        for here in 1..last {
            while back + 1 < here && self.off(&self.between(back + 1, here)) >= SPAN {
                back += 1;
            }
            ahead = ahead.max(here + 1);
            while ahead < last && self.off(&self.between(here, ahead)) < SPAN {
                ahead += 1;
            }
            let bend = self.bend_deg(back, here, ahead);
            let is_corner = bend > self.curve.corner_above_deg || self.arc(here) > FAR_ARC;
            if best.is_some() && (!is_corner || self.off(&self.between(group, here)) >= SPAN) {
                corners.extend(best.take().map(|(corner, _)| corner));
            }
            if is_corner {
                group = if best.is_none() { here } else { group };
                best = best.filter(|(_, most)| *most >= bend).or(Some((here, bend)));
            }
        }
        corners.extend(best.map(|(corner, _)| corner));
        corners
    }

    /// Returns the angle between the lines from one place to another and on to a third, in degrees.
    fn bend_deg(&self, back: usize, here: usize, ahead: usize) -> f64 {
        let (one, other) = (self.between(back, here), self.between(here, ahead));
        let dot = |one: &Place, other: &Place| one.iter().zip(other).map(|(one, other)| one * other).sum::<f64>();
        (dot(&one, &other) / (dot(&one, &one) * dot(&other, &other)).sqrt()).clamp(-1.0, 1.0).acos().to_degrees()
    }

    /// Returns the distance, in tolerances, from the straight lines of an arc through a place and its neighbours that
    /// is as long as the shorter line.
    fn arc(&self, here: usize) -> f64 {
        let (one, other) = (self.between(here - 1, here), self.between(here, here + 1));
        let (length, next) = (norm(&one), norm(&other));
        let shorter = length.min(next);
        let off = std::array::from_fn(|which| (other[which] / next - one[which] / length) * shorter / 8.0);
        self.off(&off)
    }

    /// Returns the number of the way-point at a place, from 1.
    fn way_point(&self, place: usize) -> usize {
        self.place_of.partition_point(|other| *other <= place)
    }
}

impl<'g> Section<'g> {
    fn new(given: &'g Given<'g>, [from, to]: [usize; 2], share: f64) -> Self {
        let arc = |place: usize| if place > from && place < to { given.arc(place) } else { 0.0 };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 16")]
        let parts = (from..to)
            .map(|place| {
                let most = arc(place).max(arc(place + 1)) / NEAR_ARC;
                (most.sqrt().ceil() as usize).clamp(1, MOST_PARTS[0])
            })
            .collect();
        Self { given, from, to, share, parts }
    }

    /// Returns the spline within the tolerance of its lines.
    ///
    /// # Errors
    /// Places that must be corners, since more parts do not help.
    fn spline(&mut self) -> Result<Spline, Vec<usize>> {
        loop {
            let (at, places) = self.nodes();
            let spline = Spline::near(at.clone(), &places, |off| self.given.off(off) / (self.share * OF_SPLINE));
            let mut far = Vec::new();
            let mut node = 0;
            for (way, parts) in self.parts.iter().enumerate() {
                let is_far = (node..node + parts).any(|node| {
                    [0.25, 0.5, 0.75].into_iter().any(|share| {
                        let there = spline.at(at[node] + share * (at[node + 1] - at[node]))[0];
                        let off = std::array::from_fn(|which| {
                            let [one, other] = [places[node][which], places[node + 1][which]];
                            there[which] - one - share * (other - one)
                        });
                        self.given.off(&off) > self.share * OF_WAYS
                    })
                });
                node += parts;
                if is_far {
                    far.push(way);
                }
            }
            let corners: Vec<_> = far
                .iter()
                .filter(|way| self.parts[**way] >= MOST_PARTS[1])
                .filter_map(|way| self.sharper_end(self.from + way))
                .collect();
            if !corners.is_empty() {
                return Err(corners);
            }
            far.retain(|way| self.parts[*way] < MOST_PARTS[1]);
            if far.is_empty() {
                return Ok(spline);
            }
            for way in far {
                self.parts[way] *= 2;
            }
        }
    }

    /// Returns the end of a line at which the curve bends more; `None` if the line is the whole section.
    fn sharper_end(&self, place: usize) -> Option<usize> {
        let ends = [place, place + 1].into_iter().filter(|end| *end > self.from && *end < self.to);
        ends.max_by(|one, other| self.given.arc(*one).total_cmp(&self.given.arc(*other)))
    }

    /// Returns the parameters and places of its nodes.
    fn nodes(&self) -> (Vec<f64>, Vec<Place>) {
        let (mut at, mut places) = (vec![0.0], vec![self.given.places[self.from]]);
        for (place, parts) in (self.from..self.to).zip(&self.parts) {
            let (one, way) = (self.given.places[place], self.given.between(place, place + 1));
            let (start, length) = (at[at.len() - 1], norm(&way));
            for part in 1..=*parts {
                #[expect(clippy::cast_precision_loss, reason = "at most 32")]
                let share = part as f64 / *parts as f64;
                at.push(start + share * length);
                places.push(std::array::from_fn(|which| one[which] + share * way[which]));
            }
        }
        (at, places)
    }

    /// Returns the leg along a spline.
    fn leg(&self, spline: &Spline, begin: &mut Begin<'_>) -> Result<Leg, TrajectoryError> {
        let Given { checker, space, curve, .. } = *self.given;
        let Tolerances { mm, turn_deg, joint_deg } = curve.tolerances;
        let deg = if space == Space::Tool { turn_deg } else { joint_deg };
        let off = |tolerance: f64| (self.share * OF_POLYNOMIALS * tolerance).min(MOST_OFF);
        let near = Nearness { mm: off(mm), deg: off(deg) };
        let mut node = 0;
        let points: Vec<f64> = self.parts[..self.parts.len() - 1]
            .iter()
            .map(|parts| {
                node += parts;
                spline.nodes()[node]
            })
            .collect();
        let after = self.given.way_point(self.from);
        let (path, end) = CurvePath::new(spline, &points, space, begin, near).map_err(|Lost { at, exceeded }| {
            let after = self.given.way_point(self.from + points.partition_point(|point| *point <= at));
            TrajectoryError::between(after, checker, exceeded.unwrap_or(Exceeded::NotConfirmed))
        })?;
        let start = begin.start.joints;
        begin.start = end;
        Ok(Leg::new(after, path.length(), start, LegPath::Curve(path)))
    }
}

fn norm(place: &Place) -> f64 {
    place.iter().map(|number| number * number).sum::<f64>().sqrt()
}
