"""A simulated robot for tests: `jaka sim` as a program of its own, and JSON on its two ports."""

import codecs
import json
import re
import socket
import subprocess
import threading
import time

# How long each thing may take, in s.
LIMIT = 60


class Messages:
    """A connection, and the JSON objects that come on it one after the other."""

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=LIMIT)
        self.decoder = codecs.getincrementaldecoder("utf-8")()
        self.text = ""

    def next(self):
        while True:
            try:
                message, end = json.JSONDecoder().raw_decode(self.text)
                self.text = self.text[end:].lstrip()
                return message
            except json.JSONDecodeError:
                # It has not come as a whole yet.
                received = self.socket.recv(65536)
                if not received:
                    raise ConnectionError("the controller has ended the connection")
                self.text += self.decoder.decode(received)

    def until(self, condition):
        """The first of them that is so."""
        end = time.monotonic() + LIMIT
        while time.monotonic() < end:
            message = self.next()
            if condition(message):
                return message
        raise TimeoutError("no such message has come")


class SimulatedRobot:
    """`jaka sim` on free ports, with these options, until the end of the `with` block."""

    def __init__(self, *options):
        command = ["jaka", "sim", "--commands", "0", "--status", "0", "--stdin", *options]
        self.program = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        # Whatever goes wrong, it ends, and with it each wait for it.
        self.end = threading.Timer(2 * LIMIT, self.program.kill)
        self.end.daemon = True
        self.end.start()
        # "commands at 127.0.0.1:40001, status at 127.0.0.1:40000"
        ports = re.findall(r":(\d+)", self.program.stdout.readline())
        command_port, self.status_port = map(int, ports)
        self.commands = Messages(command_port)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end.cancel()
        self.program.kill()
        self.program.communicate()

    def call(self, command, **fields):
        """The reply to a command, on what is port 10001 of a real controller."""
        self.commands.socket.sendall(json.dumps({"cmdName": command, **fields}).encode())
        reply = self.commands.next()
        assert reply["cmdName"] == command, reply
        return reply

    def status(self):
        """The packets of what is port 10000 of a real controller, from now on."""
        return Messages(self.status_port)

    def happen(self, event):
        """Has something happen to the arm, such as `collide`, `cut-power` or `input 3 high at 5s`."""
        self.program.stdin.write(event + "\n")
        self.program.stdin.flush()
