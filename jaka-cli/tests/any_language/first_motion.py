"""The arm is powered and enabled, turns joint 1 by 5 deg, and packets show it there."""

from simulated_robot import SimulatedRobot

with SimulatedRobot("--fast") as robot:
    turn = {"relFlag": 1, "jointPosition": [5, 0, 0, 0, 0, 0], "speed": 50, "accel": 200}
    assert robot.call("joint_move", **turn)["errorCode"] == "2", "it has no power"
    assert robot.call("power_on")["errorCode"] == "0"
    assert robot.call("enable_robot")["errorCode"] == "0"
    start = robot.call("get_joint_pos")["joint_pos"][0]
    assert robot.call("joint_move", **turn)["errorCode"] == "0"

    def is_there(packet):
        assert packet["powered_on"] == 1 and packet["enabled"] is True
        return abs(packet["joint_actual_position"][0] - start - 5) < 1e-6 and packet["inpos"]

    robot.status().until(is_there)
    robot.commands.socket.sendall(b'{"cmdName": "no_such_command"}')
    assert robot.commands.next() == {"errorCode": "1", "errorMsg": "Exception:function call failed"}
