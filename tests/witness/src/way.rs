//! Ways of an arm, step by step, and by how much they are beyond limits: computed a second time, without jaka-motion.

use super::{Frame, Witness, inverse, product};

/// Limits of an arm, in plain figures.
#[derive(Debug, Clone)]
pub struct Bounds {
    /// The arm.
    pub arm: Witness,
    /// The lower ends of the joints' ranges, in degrees.
    pub joint_min: [f64; 6],
    /// The upper ends.
    pub joint_max: [f64; 6],
    /// The joints' speeds, in deg/s.
    pub speeds: [f64; 6],
    /// The joints' accelerations, in deg/s².
    pub accelerations: [f64; 6],
    /// The speed of the tool centre point, in mm/s.
    pub tcp_speed: f64,
    /// The least distance from a singularity.
    pub least: f64,
    /// The sum of the arm's lengths, in mm.
    pub reach: f64,
    /// Zones for points of the arm.
    pub zones: Vec<Zone>,
    /// The arm's base, seen from the frame of poses.
    pub base: Frame,
    /// The tool, seen from the flange.
    pub tool: Frame,
}

/// Permitted space of a point of the arm.
#[derive(Debug, Clone)]
pub struct Zone {
    /// The point: 0 the elbow, 1 the wrist, 2 the tool centre point.
    pub point: usize,
    /// Whether the shape is given in the frame of poses, and not in the frame of the arm's base.
    pub in_user: bool,
    /// The shape.
    pub shape: Shape,
}

/// The shape of a zone, in mm.
#[derive(Debug, Clone, Copy)]
pub enum Shape {
    /// Inside this box.
    Inside([f64; 3], [f64; 3]),
    /// Outside this box.
    Outside([f64; 3], [f64; 3]),
    /// On the side of a plane through a point to which a direction of length 1 points.
    Half([f64; 3], [f64; 3]),
}

/// Largest excess over each limit along a path. Negative where there is room.
#[derive(Debug, Clone, Copy)]
pub struct Excess {
    /// Of a joint's range, in degrees.
    pub degrees: f64,
    /// Of a zone, in mm.
    pub millimetres: f64,
    /// Of a speed, as a share of its limit.
    pub speed: f64,
    /// Of an acceleration, as a share of its limit.
    pub acceleration: f64,
    /// Of the least distance from a singularity.
    pub singularity: f64,
    /// Whether the way could not be followed: no joint positions were found that go on from those before.
    pub is_lost: bool,
}

/// The way of the tool centre point, seen from the arm's base.
#[derive(Debug, Clone, Copy)]
pub enum Path {
    /// Straight, turned evenly about one axis.
    Line(Frame),
    /// Along the circle through a middle frame to the last one.
    Arc(Frame, Frame),
}

/// Acceleration and jerk of stops by default, in deg/s² and deg/s³.
const STOP_ACCELERATION: f64 = 570.0;
const STOP_JERK: f64 = 5700.0;

/// The steps in which ways are followed: degrees of a joint, and mm of a point.
#[derive(Debug, Clone, Copy)]
pub struct Steps {
    /// Of each joint, in degrees.
    pub degrees: f64,
    /// Of each point, in mm.
    pub millimetres: f64,
}

/// The least number of pieces of a line or an arc: on an arc of a millimetre the direction changes within tenths of
/// one.
const LEAST_PIECES: f64 = 400.0;

impl Excess {
    const NONE: Self = Self {
        degrees: f64::NEG_INFINITY,
        millimetres: f64::NEG_INFINITY,
        speed: f64::NEG_INFINITY,
        acceleration: f64::NEG_INFINITY,
        singularity: f64::NEG_INFINITY,
        is_lost: false,
    };

    fn or(self, other: Self) -> Self {
        Self {
            degrees: self.degrees.max(other.degrees),
            millimetres: self.millimetres.max(other.millimetres),
            speed: self.speed.max(other.speed),
            acceleration: self.acceleration.max(other.acceleration),
            singularity: self.singularity.max(other.singularity),
            is_lost: self.is_lost || other.is_lost,
        }
    }

    /// Whether some limit is exceeded by more than these amounts: degrees, mm, a share of a speed, a distance from a
    /// singularity.
    pub fn is_beyond(&self, [degrees, millimetres, speed, singularity]: [f64; 4]) -> bool {
        self.is_lost
            || self.degrees > degrees
            || self.millimetres > millimetres
            || self.speed > speed
            || self.acceleration > speed
            || self.singularity > singularity
    }
}

impl Bounds {
    /// The tool for joint positions, seen from the arm's base.
    pub fn tcp(&self, joints: [f64; 6]) -> Frame {
        product(self.arm.flange(joints), self.tool)
    }

    /// At a place.
    pub fn place(&self, joints: [f64; 6]) -> Excess {
        self.at(joints, 0.0)
    }

    /// A way straight in joint space, the joint with the longest way at this speed and acceleration.
    pub fn joint_way(&self, from: [f64; 6], to: [f64; 6], speed: f64, acceleration: f64, steps: Steps) -> Excess {
        let by: [f64; 6] = std::array::from_fn(|joint| to[joint] - from[joint]);
        let longest = by.iter().fold(0.0_f64, |longest, by| longest.max(by.abs()));
        let mut excess = self.at(from, 0.0).or(self.at(to, 0.0));
        if longest == 0.0 {
            return excess;
        }
        for (joint, by) in by.iter().enumerate() {
            let share = by.abs() / longest;
            excess.speed = excess.speed.max(speed * share / self.speeds[joint] - 1.0);
            excess.acceleration = excess.acceleration.max(acceleration * share / self.accelerations[joint] - 1.0);
        }
        let at = |share: f64| -> [f64; 6] { std::array::from_fn(|joint| from[joint] + by[joint] * share) };
        // Finer where a piece of it goes too far, which pieces of a degree tell.
        let mut pieces = (longest / steps.degrees.max(1.0)).ceil().max(1.0);
        loop {
            let (mut found, mut furthest, mut before) = (Excess::NONE, 0.0_f64, None::<[[f64; 3]; 3]>);
            let mut share = 0.0;
            while share < 1.0 {
                let points = self.points(at(share));
                found.millimetres = found.millimetres.max(self.zones_at(&points, 0.0));
                if let Some(before) = before {
                    for (one, other) in before.iter().zip(&points) {
                        furthest = furthest.max(distance(*one, *other));
                    }
                    let moved = distance(before[2], points[2]);
                    let tcp_speed = moved / (longest / pieces / speed);
                    found.speed = found.speed.max(tcp_speed / self.tcp_speed - 1.0);
                }
                before = Some(points);
                share += 1.0 / pieces;
            }
            let finer = (furthest / steps.millimetres).max(longest / pieces / steps.degrees);
            if finer <= 1.0 || pieces > 1e6 {
                return excess.or(found);
            }
            pieces = (pieces * finer * 1.02).ceil();
        }
    }

    /// A way of the tool centre point at a speed in mm/s, with blending of so many mm; and the joint positions at its
    /// end.
    pub fn tcp_way(
        &self,
        from: [f64; 6],
        path: Path,
        speed: f64,
        tolerance: f64,
        steps: Steps,
    ) -> (Excess, Option<[f64; 6]>) {
        let start = self.tcp(from);
        let (length, turn) = path.size(start);
        let mut excess = self.at(from, tolerance);
        excess.speed = speed / self.tcp_speed - 1.0;
        excess.singularity = self.least - self.nearest_singularity(from);
        let pieces = (length / steps.millimetres).max(turn / steps.degrees).ceil().max(LEAST_PIECES);
        let (mut joints, mut done) = (from, 0.0);
        while done < pieces {
            // Near a singularity the joints go far in a step, which is halved then.
            let mut step: f64 = 1.0;
            let next = loop {
                let target = product(path.at(start, ((done + step) / pieces).min(1.0)), inverted(self.tool));
                match inverse(&self.arm, target, joints) {
                    Some(next) if largest(&next, &joints) < 1.0 => break next,
                    _ if step > 1e-3 => step /= 2.0,
                    _ => return (Excess { is_lost: true, ..excess }, None),
                }
            };
            let (moved, time) = (length * step / pieces, length * step / pieces / speed);
            excess = excess.or(self.at(next, tolerance));
            excess.singularity = excess.singularity.max(self.least - self.nearest_singularity(next));
            if moved > 1e-6 && length >= 0.1 {
                for joint in 0..6 {
                    let turned = (next[joint] - joints[joint]).abs() / time;
                    excess.speed = excess.speed.max(turned / self.speeds[joint] - 1.0);
                }
            }
            (joints, done) = (next, done + step);
        }
        (excess, Some(joints))
    }

    /// A set-point after the last two, a period in seconds later.
    pub fn set_point(&self, before: [[f64; 6]; 2], to: [f64; 6], period: f64, steps: Steps) -> Excess {
        let [earlier, last] = before;
        let mut excess = self.at(to, 0.0);
        for joint in 0..6 {
            let (moved, moved_before) = (to[joint] - last[joint], last[joint] - earlier[joint]);
            excess.speed = excess.speed.max(moved.abs() / period / self.speeds[joint] - 1.0);
            let acceleration = (moved - moved_before).abs() / period / period;
            // A joint that turns back within the period has slowed down, too, if it sets off within the other
            // acceleration.
            let back = if moved * moved_before < 0.0 { moved.abs() / period / period } else { 0.0 };
            let slows = moved.abs() < moved_before.abs() && back <= self.accelerations[joint];
            let most = if slows { self.accelerations[joint].max(STOP_ACCELERATION) } else { self.accelerations[joint] };
            excess.acceleration = excess.acceleration.max(acceleration / most - 1.0);
        }
        let (here, there) = (self.points(last)[2], self.points(to)[2]);
        excess.speed = excess.speed.max(distance(here, there) / period / self.tcp_speed - 1.0);
        // Speeds and accelerations of the pieces of this way are those of a motion without limits.
        let mut way = self.joint_way(last, to, 1e-9, 1e-9, steps);
        (way.speed, way.acceleration) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        excess.or(way).or(self.landing(last, to, period, steps))
    }

    /// On the way to a stop after a set-point. Either step after step, each shorter than the one before by as much as
    /// the first allows; or the fastest joint with the acceleration and the jerk of a stop, whichever is shorter.
    fn landing(&self, last: [f64; 6], to: [f64; 6], period: f64, steps: Steps) -> Excess {
        let moved: [f64; 6] = std::array::from_fn(|joint| to[joint] - last[joint]);
        let mut count = 1_u32;
        let is_soft = |count: u32| {
            let slows = |joint: usize| moved[joint].abs() / period / f64::from(count) / period;
            (0..6).all(|joint| slows(joint) <= self.accelerations[joint])
        };
        while !is_soft(count) && count < 100_000 {
            count += 1;
        }
        let even = (1..count).map(|step| 1.0 - f64::from(step) / f64::from(count)).sum::<f64>();
        let fastest = moved.iter().fold(0.0, |most: f64, moved| most.max(moved.abs())) / period;
        // What braking takes is as long again as its first half, at the mean of both speeds.
        let seconds = if fastest * STOP_JERK < STOP_ACCELERATION * STOP_ACCELERATION {
            2.0 * (fastest / STOP_JERK).sqrt()
        } else {
            fastest / STOP_ACCELERATION + STOP_ACCELERATION / STOP_JERK
        };
        let share = even.min(0.5 * seconds / period);
        let end = std::array::from_fn(|joint| to[joint] + share * moved[joint]);
        let mut way = self.joint_way(to, end, 1e-9, 1e-9, steps);
        (way.speed, way.acceleration) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        way
    }

    /// The least of the distances from the singularities of shoulder, elbow and wrist; that of the whole arm where the
    /// forearm turns about itself and the wrist has an offset.
    pub fn nearest_singularity(&self, joints: [f64; 6]) -> f64 {
        let frames = self.arm.frames(joints);
        let at = |index: usize| frames[index].map(|row| row[3]);
        let axis = |index: usize| frames[index].map(|row| row[2]);
        if dot(axis(1), axis(3)).abs() < 0.5 && distance(at(3), at(4)) > 1.0 {
            let along = dot(axis(1), minus(at(2), at(1)));
            let (upper_arm, forearm) = (distance(at(1), at(2)), distance(at(2), at(3)));
            let upper_arm = (upper_arm * upper_arm - along * along).sqrt();
            let columns: [[f64; 6]; 6] = std::array::from_fn(|joint| {
                let moved = cross(axis(joint), minus(at(5), at(joint)));
                std::array::from_fn(|row| if row < 3 { moved[row] } else { axis(joint)[row - 3] })
            });
            return determinant(columns).abs() / (upper_arm * forearm * (upper_arm + forearm));
        }
        let shoulder = dot(cross(axis(0), axis(1)), minus(at(4), at(0))).abs() / self.reach;
        let in_plane = |bar: [f64; 3]| {
            let out = dot(axis(1), bar);
            let away = axis(1).map(|part| part * out);
            minus(bar, away)
        };
        let (upper_arm, forearm) = (in_plane(minus(at(2), at(1))), in_plane(minus(at(3), at(2))));
        let elbow = norm(cross(upper_arm, forearm)) / (norm(upper_arm) * norm(forearm));
        let wrist = norm(cross(axis(3), axis(5)));
        shoulder.min(elbow).min(wrist)
    }

    /// Elbow, wrist and tool centre point, seen from the arm's base.
    fn points(&self, joints: [f64; 6]) -> [[f64; 3]; 3] {
        let frames = self.arm.frames(joints);
        let tcp = product(self.arm.flange_of(&frames), self.tool);
        [frames[2], frames[4], tcp].map(place)
    }

    /// Ranges and zones.
    fn at(&self, joints: [f64; 6], tolerance: f64) -> Excess {
        let mut excess = Excess::NONE;
        for ((min, joint), max) in self.joint_min.iter().zip(joints).zip(&self.joint_max) {
            let over = (min - joint).max(joint - max);
            excess.degrees = excess.degrees.max(over);
        }
        excess.millimetres = self.zones_at(&self.points(joints), tolerance);
        excess
    }

    /// Largest excess of points over their zones, in mm.
    fn zones_at(&self, points: &[[f64; 3]; 3], tolerance: f64) -> f64 {
        let excess = |zone: &Zone| {
            let point = points[zone.point];
            zone.shape.excess(if zone.in_user { seen(self.base, point) } else { point }) + tolerance
        };
        self.zones.iter().map(excess).fold(f64::NEG_INFINITY, f64::max)
    }
}

/// The determinant, by elimination.
fn determinant(mut rows: [[f64; 6]; 6]) -> f64 {
    let mut product = 1.0;
    for pivot in 0..6 {
        let largest = (pivot..6).fold(
            pivot,
            |best, row| {
                if rows[row][pivot].abs() > rows[best][pivot].abs() { row } else { best }
            },
        );
        if largest != pivot {
            rows.swap(pivot, largest);
            product = -product;
        }
        let from = rows[pivot];
        product *= from[pivot];
        if from[pivot] == 0.0 {
            return 0.0;
        }
        for row in &mut rows[pivot + 1..] {
            let factor = row[pivot] / from[pivot];
            row.iter_mut().zip(from).for_each(|(entry, from)| *entry -= factor * from);
        }
    }
    product
}

impl Shape {
    fn excess(&self, at: [f64; 3]) -> f64 {
        let past = |min: [f64; 3], max: [f64; 3]| {
            (0..3).map(|axis| (min[axis] - at[axis]).max(at[axis] - max[axis])).fold(f64::NEG_INFINITY, f64::max)
        };
        match *self {
            Self::Inside(min, max) => past(min, max),
            Self::Outside(min, max) => -past(min, max),
            Self::Half(border, inward) => dot(inward, minus(border, at)),
        }
    }
}

impl Path {
    /// Its length in mm, and how far it turns in degrees.
    fn size(&self, from: Frame) -> (f64, f64) {
        match *self {
            Self::Line(to) => (distance(place(from), place(to)), turn_between(from, to).1.to_degrees()),
            Self::Arc(mid, to) => {
                let turn = turn_between(from, mid).1 + turn_between(mid, to).1;
                let length = circle(from, mid, to).map_or(0.0, |circle| circle.radius * circle.angles[1]);
                (length, turn.to_degrees())
            }
        }
    }

    fn at(&self, from: Frame, share: f64) -> Frame {
        match *self {
            Self::Line(to) => {
                let (one, other) = (place(from), place(to));
                let place = std::array::from_fn(|axis| one[axis] + (other[axis] - one[axis]) * share);
                turned(from, to, share, place)
            }
            Self::Arc(mid, to) => {
                let Some(circle) = circle(from, mid, to) else { return from };
                let angle = circle.angles[1] * share;
                let place = circle.at(angle);
                if angle < circle.angles[0] {
                    turned(from, mid, angle / circle.angles[0], place)
                } else {
                    turned(mid, to, (angle - circle.angles[0]) / (circle.angles[1] - circle.angles[0]), place)
                }
            }
        }
    }
}

/// A circle, and the angles on it from a first point to the second and the third.
struct Circle {
    centre: [f64; 3],
    radius: f64,
    /// At right angles to each other, the first to the first point.
    spokes: [[f64; 3]; 2],
    angles: [f64; 2],
}

impl Circle {
    fn at(&self, angle: f64) -> [f64; 3] {
        let (sin, cos) = angle.sin_cos();
        std::array::from_fn(|axis| {
            self.centre[axis] + self.radius * (cos * self.spokes[0][axis] + sin * self.spokes[1][axis])
        })
    }
}

/// Through three places; none on a line.
fn circle(from: Frame, mid: Frame, to: Frame) -> Option<Circle> {
    let (a, b, c) = (place(from), place(mid), place(to));
    let (ab, ac) = (minus(b, a), minus(c, a));
    let normal = cross(ab, ac);
    let area = dot(normal, normal);
    if area < 1e-9 {
        return None;
    }
    let (one, other) =
        (cross(normal, ab).map(|part| part * dot(ac, ac)), cross(ac, normal).map(|part| part * dot(ab, ab)));
    let to_centre: [f64; 3] = std::array::from_fn(|axis| (one[axis] + other[axis]) / (2.0 * area));
    let centre = std::array::from_fn(|axis| a[axis] + to_centre[axis]);
    let radius = norm(to_centre);
    let first = to_centre.map(|part| -part / radius);
    let second = cross(normal.map(|part| part / area.sqrt()), first);
    let angle = |point: [f64; 3]| {
        let spoke = minus(point, centre);
        dot(spoke, second).atan2(dot(spoke, first)).rem_euclid(std::f64::consts::TAU)
    };
    Some(Circle { centre, radius, spokes: [first, second], angles: [angle(b), angle(c)] })
}

/// One frame turned by a share of the way to another, at a place.
fn turned(from: Frame, to: Frame, share: f64, place: [f64; 3]) -> Frame {
    let (axis, angle) = turn_between(from, to);
    let mut frame = product(from, about(axis, angle * share));
    for (row, part) in frame.iter_mut().zip(place) {
        row[3] = part;
    }
    frame
}

/// The axis, seen from the first frame, and the angle of the turn from one to the other.
fn turn_between(from: Frame, to: Frame) -> ([f64; 3], f64) {
    let turn = product(inverted(from), to);
    let sines = [turn[2][1] - turn[1][2], turn[0][2] - turn[2][0], turn[1][0] - turn[0][1]];
    let (sine, cosine) = (norm(sines) / 2.0, (turn[0][0] + turn[1][1] + turn[2][2] - 1.0) / 2.0);
    if sine < 1e-12 {
        return ([0.0, 0.0, 1.0], 0.0);
    }
    (sines.map(|part| part / (2.0 * sine)), sine.atan2(cosine))
}

/// A turn about an axis of length 1.
fn about(axis: [f64; 3], angle: f64) -> Frame {
    let (sin, cos) = angle.sin_cos();
    let [x, y, z] = axis;
    let less = 1.0 - cos;
    [
        [cos + x * x * less, x * y * less - z * sin, x * z * less + y * sin, 0.0],
        [y * x * less + z * sin, cos + y * y * less, y * z * less - x * sin, 0.0],
        [z * x * less - y * sin, z * y * less + x * sin, cos + z * z * less, 0.0],
    ]
}

/// The other frame, seen from this one.
pub fn inverted(frame: Frame) -> Frame {
    let mut inverse = [[0.0; 4]; 3];
    for (row, out) in inverse.iter_mut().enumerate() {
        for column in 0..3 {
            out[column] = frame[column][row];
            out[3] -= frame[column][row] * frame[column][3];
        }
    }
    inverse
}

fn seen(frame: Frame, point: [f64; 3]) -> [f64; 3] {
    frame.map(|row| row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3])
}

fn place(frame: Frame) -> [f64; 3] {
    frame.map(|row| row[3])
}

fn largest(one: &[f64; 6], other: &[f64; 6]) -> f64 {
    one.iter().zip(other).fold(0.0, |most, (one, other)| most.max((one - other).abs()))
}

fn distance(one: [f64; 3], other: [f64; 3]) -> f64 {
    norm(minus(one, other))
}

fn minus(one: [f64; 3], other: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| one[axis] - other[axis])
}

fn dot(one: [f64; 3], other: [f64; 3]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

fn norm(vector: [f64; 3]) -> f64 {
    dot(vector, vector).sqrt()
}

fn cross(one: [f64; 3], other: [f64; 3]) -> [f64; 3] {
    [
        one[1] * other[2] - one[2] * other[1],
        one[2] * other[0] - one[0] * other[2],
        one[0] * other[1] - one[1] * other[0],
    ]
}
