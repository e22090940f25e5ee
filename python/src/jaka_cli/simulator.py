"""`jaka sim`, a simulated controller, as a process with a beginning and an end."""

import re
import subprocess
import tempfile
import threading

from jaka_cli.program import program_path

# Time in seconds within which a simulator must listen.
START_LIMIT = 60


class Simulator:
    """A simulated controller on free ports of this machine, until the end of its `with` block.

    Options are those of `jaka sim`: `Simulator("--powered", "--model", "zu12")`.

    Attributes:
        host: address of both ports, 127.0.0.1 unless the option `--address` gives another one
        command_port: port of commands, 10001 of a real controller
        status_port: port of status packets, 10000 of a real controller
        process: the `subprocess.Popen` of the simulator
    """

    def __init__(self, *options: str):
        command = [str(program_path()), "sim", "--commands", "0", "--status", "0", *options]
        # A file, since a pipe that nobody reads holds the simulator up when it is full.
        self._errors = tempfile.TemporaryFile()
        self.process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=self._errors, encoding="utf-8"
        )
        # Reads events and the log, which the simulator prints, for the same reason.
        self._reader = threading.Thread(target=self.process.stdout.read, daemon=True)
        try:
            self.host, self.command_port, self.status_port = self._read_addresses()
        except BaseException:
            self.close()
            raise
        self._reader.start()

    @property
    def commands(self):
        """Address of the command port, for `socket.create_connection`."""
        return self.host, self.command_port

    @property
    def status(self):
        """Address of the status port, for `socket.create_connection`."""
        return self.host, self.status_port

    def close(self):
        """Ends the simulator, and returns when it has ended."""
        self.process.kill()
        self.process.wait()
        if self._reader.is_alive():
            self._reader.join()
        self.process.stdout.close()
        self._errors.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _read_addresses(self):
        # Its end makes `readline` return.
        limit = threading.Timer(START_LIMIT, self.process.kill)
        limit.start()
        line = self.process.stdout.readline()
        limit.cancel()
        # "commands at 127.0.0.1:40001, status at 127.0.0.1:40000"
        found = re.fullmatch(r"commands at (.+):(\d+), status at .+:(\d+)\n", line)
        if found:
            return found[1].strip("[]"), int(found[2]), int(found[3])
        self.process.kill()
        code = self.process.wait()
        self._errors.seek(0)
        text = self._errors.read().decode("utf-8", "replace").strip()
        raise RuntimeError(f"the simulator did not start, exit code {code}: {text or repr(line)}")
