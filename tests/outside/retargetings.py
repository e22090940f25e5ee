"""Compares the durations of retargetings with those of Ruckig: none takes longer than 1.02 times the better of two ways of Ruckig, whose
greatest speeds differ by a billionth, and one period. Where a joint moves with its greatest speed, Ruckig itself is singular."""

import json
import sys

from ruckig import InputParameter, Result, Ruckig, Synchronization, Trajectory

JOINTS = 6
ALLOWED = 1.02
CRUISE = 0.998


def duration(case, factor):
    """Of Ruckig's way, in seconds; none where it finds none."""
    speeds, accelerations, jerks = case["limits"]
    given = InputParameter(JOINTS)
    given.current_position, given.current_velocity, given.current_acceleration = case["state"]
    given.target_position = case["target"]
    given.max_velocity = [speed * factor for speed in speeds]
    given.max_acceleration, given.max_jerk = accelerations, jerks
    given.synchronization = Synchronization.Phase
    way = Trajectory(JOINTS)
    found = Ruckig(JOINTS).calculate(given, way)
    return way.duration if found in (Result.Working, Result.Finished) else None


def main(path):
    cases = [json.loads(line) for line in open(path, encoding="utf-8")]
    at_cruise = slow = bound = 0
    worst = 0.0
    for case in cases:
        speeds = case["limits"][0]
        at_cruise += any(abs(v) > CRUISE * most for v, most in zip(case["state"][1], speeds))
        if case["is_bound"]:
            bound += 1
            continue
        found = [way for factor in (1 - 1e-9, 1 + 1e-9) if (way := duration(case, factor)) is not None]
        if not found:
            sys.exit(f"Ruckig finds no way: {case}")
        best = min(found)
        ratio = (case["took_s"] - case["period_s"]) / best
        worst = max(worst, ratio)
        if ratio > ALLOWED:
            slow += 1
            print(f"{case['took_s']:.3f} s, Ruckig {best:.3f} s: {json.dumps(case)}")
    compared = len(cases) - bound
    print(f"{len(cases)} retargetings, {at_cruise} of them with a joint at cruise, {compared} compared: {slow} take longer than "
          f"{ALLOWED} times Ruckig and a period; the worst takes {worst:.4f} times")
    sys.exit(1 if slow or at_cruise < 2000 or bound > len(cases) // 20 else 0)


main(sys.argv[1])
