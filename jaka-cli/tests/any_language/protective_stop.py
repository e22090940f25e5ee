"""A collision while the arm moves: it stops, and moves again only after `clear_error`."""

from simulated_robot import SimulatedRobot

with SimulatedRobot("--powered") as robot:
    status = robot.status()
    start = status.next()["joint_actual_position"][0]
    turn = {"relFlag": 1, "jointPosition": [60, 0, 0, 0, 0, 0], "speed": 1, "accel": 100}
    assert robot.call("joint_move", **turn)["errorCode"] == "0"
    status.until(lambda packet: packet["joint_actual_position"][0] > start + 1)

    robot.happen("collide")
    packet = status.until(lambda packet: packet["protective_stop"] == 1)
    assert packet["errcode"] == "0xf0034", packet["errcode"]
    assert robot.call("protective_stop_status")["protective_stop"] == "1"
    assert robot.call("joint_move", **turn)["errorCode"] != "0", "refused while it stands"
    stopped = robot.call("get_joint_pos")["joint_pos"][0]
    assert start + 1 < stopped < start + 60, stopped

    # Here a program must have a person look at the arm.
    assert robot.call("clear_error")["errorCode"] == "0"
    packet = status.until(lambda packet: packet["protective_stop"] == 0)
    assert packet["enabled"] is True and packet["joint_actual_position"][0] == stopped, "the motion is given up"
    assert robot.call("joint_move", **turn)["errorCode"] == "0"
    status.until(lambda packet: packet["joint_actual_position"][0] > stopped + 1)
