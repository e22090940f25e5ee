"""Compares trajectories with their limits and tolerances, by differences of positions and kinematics of its own, and their durations with
those of TOPP-RA on the same path, which has no limit of jerk, and of Ruckig with a stop at each point.

The kinematics are those of the vendor's URDF of the Zu 5 (`JakaCobot/jaka_ros2`, `src/jaka_description/urdf`)."""

import json
import logging
import sys
from collections import defaultdict

import numpy as np
import toppra
from ruckig import InputParameter, Ruckig, Synchronization, Trajectory
from toppra.algorithm import TOPPRA
from toppra.constraint import JointAccelerationConstraint, JointVelocityConstraintVarying

# xyz in mm and turn about x of each joint; each turns about its z.
URDF = [
    ((0.0, 0.0, 120.15), 0.0),
    ((0.0, 0.0, 0.0), np.pi / 2),
    ((430.0, 0.0, 0.0), 0.0),
    ((368.5, -0.01185, -114.0), 0.0),
    ((0.0, -113.5, 0.0), np.pi / 2),
    ((0.0, 107.0, 0.0), -np.pi / 2),
]
# Largest ratio to TOPP-RA and the time in which the jerk reaches the acceleration.
GOALS = {"circle": 1.10, "smooth": 1.25, "noisy": 1.15, "5 random joint": 1.15, "5 random poses": 1.25}
# Rounding of differences: 1e-12 deg over the cube of a millisecond.
ALLOWED = 1 + 1e-6
PLACES = 600


def forward(joints):
    """Positions in mm and rotations of the tool for rows of joints in degrees."""
    count = len(joints)
    position, rotation = np.zeros((count, 3)), np.tile(np.eye(3), (count, 1, 1))
    for (xyz, turn), angle in zip(URDF, np.radians(joints).T):
        position = position + rotation @ np.array(xyz)
        sin, cos = np.sin(turn), np.cos(turn)
        rotation = rotation @ np.array([[1, 0, 0], [0, cos, -sin], [0, sin, cos]])
        about_z = np.tile(np.eye(3), (count, 1, 1))
        about_z[:, 0, 0] = about_z[:, 1, 1] = np.cos(angle)
        about_z[:, 1, 0] = np.sin(angle)
        about_z[:, 0, 1] = -about_z[:, 1, 0]
        rotation = rotation @ about_z
    return position, rotation


def of_poses(poses):
    """The same for poses: mm, and degrees about the fixed x, y and z."""
    (sx, sy, sz), (cx, cy, cz) = np.sin(np.radians(poses[:, 3:])).T, np.cos(np.radians(poses[:, 3:])).T
    rows = [
        [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
        [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
        [-sy, cy * sx, cy * cx],
    ]
    return poses[:, :3], np.array(rows).transpose(2, 0, 1)


def angles(one, other):
    """Degrees between rotations."""
    cosine = (np.einsum("...ij,...ij->...", one, other) - 1) / 2
    return np.degrees(np.arccos(np.clip(cosine, -1, 1)))


def to_ways(places, points, largest=None):
    """Distance of each place from the ways straight between points, by the length, or by the largest part, exact beyond `largest`."""
    ways = np.diff(points, axis=0)
    lengths = np.maximum((ways * ways).sum(1), 1e-12)
    most = np.full(len(places), np.inf)
    for first in range(0, len(ways), 200):
        way, start, length = (rows[first : first + 200] for rows in (ways, points[:-1], lengths))
        done = places[:, None] - start
        along = np.clip((done * way).sum(2) / length, 0, 1)
        off = done - along[..., None] * way
        most = np.minimum(most, (np.abs(off).max(2) if largest else np.linalg.norm(off, axis=2)).min(1))
    if largest is not None:
        # The nearest place by the largest part is another one than by the length.
        shares = np.linspace(0, 1, 2001)[:, None]
        for index in np.flatnonzero(most > largest):
            near = ((ways * (places[index] - points[:-1])).sum(1) / lengths).clip(0, 1)[:, None] * ways + points[:-1]
            way = np.argsort(np.abs(near - places[index]).max(1))[:3]
            found = [np.abs(points[one] + shares * ways[one] - places[index]).max(1).min() for one in way]
            most[index] = min(most[index], *found)
    return most


def violations(case, joints):
    """What is beyond a limit or a tolerance, and the largest shares of them."""
    period = case["period_s"]
    # At rest before and after.
    held = np.vstack([joints[:1]] * 3 + [joints] + [joints[-1:]] * 3)
    shares = {}
    for name, order, limits in [("speed", 1, case["speeds"]), ("acceleration", 2, case["acceleration"]), ("jerk", 3, case["jerk"])]:
        found = np.abs(np.diff(held, order, axis=0)) / period**order
        shares[name] = (found / np.array(limits)).max()
    position, rotation = forward(joints)
    if case["tcp_speed"]:
        shares["tcp speed"] = np.linalg.norm(np.diff(position, axis=0), axis=1).max() / period / case["tcp_speed"]
    mm, turn, deg = case["within"]
    points = np.array(case["points"])
    some = slice(None, None, max(1, len(joints) // 1500))
    if case["space"] == "joints":
        # Between two positions the joints go nearly straight.
        shares["points"] = to_ways(points, joints, deg).max() / deg
        shares["ways"] = to_ways(joints[some], points, deg).max() / deg
    else:
        places, turns = of_poses(points[1:])
        start, start_turn = forward(points[:1])
        places, turns = np.vstack([start, places]), np.concatenate([start_turn, turns])
        shares["points"] = to_ways(places, position).max() / mm
        nearest = [np.linalg.norm(position - place, axis=1).argmin() for place in places]
        shares["turns"] = angles(rotation[nearest], turns).max() / turn
        shares["ways"] = to_ways(position[some], places).max() / mm
        if case["group"].startswith("circle"):
            centre = places[0] - [80.0, 0.0, 0.0]
            off = position - centre
            shares["circle"] = np.hypot(np.hypot(off[:, 0], off[:, 1]) - 80.0, off[:, 2]).max() / mm
    return {name: share for name, share in shares.items() if not share <= ALLOWED}, shares


def fastest(case, joints):
    """Duration of TOPP-RA on the same path, in seconds. Its solver wants numbers near 1: radians."""
    joints = np.radians(joints)
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(joints, axis=0), axis=1))])
    kept = np.unique(np.searchsorted(lengths, np.linspace(0, lengths[-1], PLACES)).clip(0, len(lengths) - 1))
    dense = toppra.SplineInterpolator(lengths[kept], joints[kept])
    at = np.linspace(0, dense.path_interval[1], PLACES)
    first = dense(at, 1)
    limits = np.tile(np.radians(case["speeds"]), (PLACES, 1))
    if case["tcp_speed"]:
        step = 1e-5
        ends = [forward(np.degrees(dense(at) + sign * step * first))[0] for sign in (1, -1)]
        moved = np.linalg.norm(ends[0] - ends[1], axis=1) / (2 * step)
        by_tool = np.abs(first) * (case["tcp_speed"] / np.maximum(moved, 1e-9))[:, None]
        limits = np.where(np.abs(first) > 1e-3, np.minimum(limits, by_tool), limits)

    def speeds(place):
        here = limits[np.argmin(np.abs(at - place))]
        return np.stack([-here, here], axis=1)

    most = np.radians(np.full((6, 2), case["acceleration"]) * [-1, 1])
    constraints = [JointVelocityConstraintVarying(speeds), JointAccelerationConstraint(most)]
    solver = TOPPRA(constraints, dense, gridpoints=at, parametrizer="ParametrizeConstAccel")
    found = solver.compute_trajectory(0, 0)
    return found.duration if found is not None else None


def with_stops(case):
    """Duration of Ruckig with a stop at each point, straight between them, in seconds."""
    total = 0.0
    for start, end in zip(case["points"], case["points"][1:]):
        given = InputParameter(6)
        given.current_position, given.target_position = start, end
        given.max_velocity = case["speeds"]
        given.max_acceleration, given.max_jerk = [case["acceleration"]] * 6, [case["jerk"]] * 6
        given.synchronization = Synchronization.Phase
        way = Trajectory(6)
        Ruckig(6).calculate(given, way)
        total += way.duration
    return total


def cruise(case, joints):
    """Least and greatest share of the speed of the tool from where it first has 99 % of it until it last has."""
    speeds = np.linalg.norm(np.diff(forward(joints)[0], axis=0), axis=1) / case["period_s"] / case["tcp_speed"]
    at = np.flatnonzero(speeds > 0.99)
    return (speeds[at[0] : at[-1] + 1].min(), speeds.max()) if len(at) else (0.0, speeds.max())


def main(path):
    logging.getLogger("toppra").setLevel(logging.ERROR)
    groups, wrong = defaultdict(list), 0
    for line in open(path, encoding="utf-8"):
        case = json.loads(line)
        joints = np.array(case["set_points"])
        beyond, shares = violations(case, joints)
        if beyond:
            wrong += 1
            print(f"{case['group']}: beyond {beyond}")
        fast = fastest(case, joints)
        if fast is None:
            sys.exit(f"TOPP-RA finds no way: {case['group']}")
        row = {"took": case["duration_s"], "fast": fast, "reach": case["acceleration"] / case["jerk"], "shares": shares}
        if case["group"].startswith("5 random joint"):
            row["stops"] = with_stops(case)
        if case["tcp_speed"] and not case["group"].startswith("5 random"):
            row["cruise"] = cruise(case, joints)
        groups[case["group"]].append(row)
    missed = 0
    print(f"{'trajectories':58} {'time':>8} {'TOPP-RA':>8} {'ratio':>6} {'worst':>6} {'goal':>5}")
    for group, rows in groups.items():
        ratios = [row["took"] / (row["fast"] + row["reach"]) for row in rows]
        goal = next(goal for name, goal in GOALS.items() if group.startswith(name))
        missed += max(ratios) > goal
        took, fast = (sum(row[name] for row in rows) for name in ("took", "fast"))
        more = ""
        if "stops" in rows[0]:
            more += f"; {took / sum(row['stops'] for row in rows):.3f} x Ruckig with stops"
        if "cruise" in rows[0]:
            more += "; at cruise {:.1%} to {:.1%} of the speed".format(*rows[0]["cruise"])
        most = max(max(row["shares"].values()) for row in rows)
        print(f"{len(rows):3} {group:54} {took:8.3f} {fast:8.3f} {np.mean(ratios):6.3f} {max(ratios):6.3f} {goal:5.2f}{more}; at most {most:.4f} of a limit")
    print(f"{sum(map(len, groups.values()))} trajectories: {wrong} beyond a limit or a tolerance, {missed} groups slower than their goal")
    sys.exit(1 if wrong or missed else 0)


main(sys.argv[1])
