"""A packet each 4 s only: what the last one shows is not what is so, and only an answer on the command port is."""

import time

from simulated_robot import LIMIT, SimulatedRobot

with SimulatedRobot("--powered", "--faults", "status slow 4s") as robot:
    began = time.monotonic()
    status = robot.status()
    packet = status.next()
    start = packet["joint_actual_position"][0]
    turn = {"relFlag": 1, "jointPosition": [10, 0, 0, 0, 0, 0], "speed": 50, "accel": 200}
    assert robot.call("joint_move", **turn)["errorCode"] == "0"

    # A program that wants a packet each 500 ms must say now that it does not know the state.
    status.socket.settimeout(0.5)
    try:
        while True:
            status.next()
    except TimeoutError:
        pass
    assert robot.call("get_joint_pos")["joint_pos"][0] > start + 1, "the arm moves, which no packet shows"

    status.socket.settimeout(LIMIT)
    status.until(lambda packet: abs(packet["joint_actual_position"][0] - start - 10) < 1e-6 and packet["inpos"])
    assert time.monotonic() - began > 3.9
