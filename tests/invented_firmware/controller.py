"""A controller of an invented firmware, 9.1, in plain Python. It shares nothing with the simulator.

It serves one arm of six joints on two ports of loopback, which it prints, and has besides the commands that a client
needs for a motion:

- `demo_glide`: a motion of all joints, with keys of its own, whose reply has an object.
- `demo_halt`: a stop.
- `demo_swap_tool`: a setting after which poses mean something else.

The payload has another key, and its centroid is an object. Status packets have two new keys, and say in words whether the
arm has power.

Each request that it receives goes to standard error, a line each.
"""

import json
import socket
import sys
import threading
import time

PERIOD = 0.02
RATE = 60.0  # deg/s


class Arm:
    """Joint positions that follow a target at a constant speed."""

    def __init__(self):
        self.lock = threading.Lock()
        self.joints = [0.0, 90.0, 90.0, 90.0, -90.0, 0.0]
        self.target = list(self.joints)
        self.powered, self.enabled = False, False
        self.tool = 0
        self.weight, self.centroid = 2.5, {"x": 1.0, "y": 2.0, "z": 3.0}

    def step(self, seconds):
        with self.lock:
            for index, target in enumerate(self.target):
                way = target - self.joints[index]
                step = max(-RATE * seconds, min(RATE * seconds, way))
                self.joints[index] += step

    def is_at_rest(self):
        return all(abs(a - b) < 1e-9 for a, b in zip(self.joints, self.target))

    def pose(self):
        """A made-up pose, the same for the same joints and tool."""
        a, b, c, d, e, f = self.joints
        return [300.0 + a + 10.0 * self.tool, 100.0 + b, 400.0 + c, d, e, f]


def answer(arm, request):
    """The fields of the reply, or an error."""
    name = request["cmdName"]
    with arm.lock:
        if name == "demo_glide" and arm.enabled:
            arm.target = [float(angle) for angle in request["goal"]]
            return {"plan": {"seconds": max(abs(a - b) for a, b in zip(arm.target, arm.joints)) / RATE}}
        if name in ("demo_halt", "stop_program"):
            arm.target = list(arm.joints)
            return {}
        if name == "demo_swap_tool":
            arm.tool = int(request["slot"])
            return {}
        if name == "get_joint_pos":
            return {"joint_pos": list(arm.joints)}
        if name == "get_tcp_pos":
            return {"tcp_pos": arm.pose()}
        if name == "get_payload":
            return {"weight": arm.weight, "centroid": arm.centroid}
        if name == "set_payload" and set(request) == {"cmdName", "weight", "centroid"}:
            arm.weight = float(request["weight"])
            arm.centroid = {axis: float(request["centroid"][axis]) for axis in "xyz"}
            return {}
        if name == "get_version":
            return {"version": "9.1.0_01_X64"}
        if name == "get_robot_state":
            enable = "robot_enabled" if arm.enabled else "robot_disabled"
            return {"enable": enable, "power": "powered_on" if arm.powered else "powered_off"}
        if name in ("power_on", "enable_robot"):
            arm.powered, arm.enabled = True, arm.enabled or name == "enable_robot"
            return {}
        if name == "joint_move" and arm.enabled:
            start = arm.target if request["relFlag"] == 1 else [0.0] * 6
            arm.target = [a + b for a, b in zip(start, request["jointPosition"])]
            return {}
        if name == "is_in_servomove":
            return {"in_servomove": False}
    return None


def serve_commands(arm, listener):
    while True:
        peer, _ = listener.accept()
        peer.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        threading.Thread(target=serve_client, args=(arm, peer), daemon=True).start()


def serve_client(arm, peer):
    decoder, text = json.JSONDecoder(), ""
    try:
        while chunk := peer.recv(65536):
            text += chunk.decode()
            while text := text.lstrip():
                try:
                    request, end = decoder.raw_decode(text)
                except json.JSONDecodeError:
                    break
                print(text[:end], file=sys.stderr, flush=True)
                text = text[end:]
                fields = answer(arm, request)
                code = {"errorCode": "0", "errorMsg": ""}
                if fields is None:
                    code = {"errorCode": "1", "errorMsg": f"call {request['cmdName']} failed"}
                reply = {**code, **(fields or {}), "cmdName": request["cmdName"]}
                peer.sendall(json.dumps(reply).encode())
    except OSError:
        pass


def packet(arm):
    with arm.lock:
        status = {
            "len": 0,
            "joint_actual_position": list(arm.joints),
            "actual_position": arm.pose(),
            "inpos": arm.is_at_rest(),
            # Another type than in any other firmware.
            "powered_on": "on" if arm.powered else "off",
            "enabled": arm.enabled,
            "emergency_stop": 0,
            "protective_stop": 0,
            "paused": False,
            "errcode": "0x0",
            "errmsg": "",
            "current_tool_id": arm.tool,
            "current_user_id": 0,
            # Keys that no other firmware has.
            "glide_queue": 0,
            "motor_mood": "calm",
        }
    text = json.dumps(status)
    status["len"] = len(text)
    return json.dumps(status).encode()


def serve_status(arm, listener):
    while True:
        peer, _ = listener.accept()
        threading.Thread(target=send_packets, args=(arm, peer), daemon=True).start()


def send_packets(arm, peer):
    try:
        while True:
            peer.sendall(packet(arm))
            time.sleep(PERIOD)
    except OSError:
        pass


def main():
    arm = Arm()
    commands, status = (socket.create_server(("127.0.0.1", 0)) for _ in range(2))
    for target, listener in ((serve_commands, commands), (serve_status, status)):
        threading.Thread(target=target, args=(arm, listener), daemon=True).start()
    print(commands.getsockname()[1], status.getsockname()[1], flush=True)
    then = time.monotonic()
    while True:
        time.sleep(0.005)
        now = time.monotonic()
        arm.step(now - then)
        then = now


if __name__ == "__main__":
    main()
