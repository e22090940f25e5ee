"""The power is lost while the arm moves: it stops, is not enabled, and does not go on by itself when the power is back."""

from simulated_robot import SimulatedRobot

with SimulatedRobot("--powered", "--fast") as robot:
    status = robot.status()
    start = status.next()["joint_actual_position"][0]
    turn = {"relFlag": 1, "jointPosition": [60, 0, 0, 0, 0, 0], "speed": 1, "accel": 100}
    assert robot.call("joint_move", **turn)["errorCode"] == "0"
    status.until(lambda packet: packet["joint_actual_position"][0] > start + 1)

    robot.happen("cut-power")
    packet = status.until(lambda packet: packet["powered_on"] == 0)
    assert packet["enabled"] is False
    state = robot.call("get_robot_state")
    assert (state["power"], state["enable"]) == ("powered_off", "robot_disabled"), state
    assert robot.call("joint_move", **turn)["errorCode"] != "0", "refused without power"
    stopped = robot.call("get_joint_pos")["joint_pos"][0]
    assert start + 1 < stopped < start + 60, stopped

    assert robot.call("power_on")["errorCode"] == "0"
    assert robot.call("enable_robot")["errorCode"] == "0"
    packet = status.until(lambda packet: packet["enabled"] is True)
    assert packet["joint_actual_position"][0] == stopped and packet["inpos"], "the motion is given up"
