"""Runs a command in a terminal until one of its pages shows a text, and ends it by Ctrl-C.

    python3 terminal.py TEXT COMMAND...
"""

import fcntl
import os
import pty
import re
import select
import signal
import struct
import sys
import termios
import time

SECONDS = 30
PAGE = 0.5
SIZE = struct.pack("HHHH", 50, 160, 0, 0)


def main():
    text, command = sys.argv[1], sys.argv[2:]
    child, terminal = pty.fork()
    if child == 0:
        os.execv(command[0], command)
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, SIZE)
    shown, end, is_found = "", time.monotonic() + SECONDS, False
    turn = time.monotonic() + PAGE
    while not is_found and time.monotonic() < end:
        if time.monotonic() > turn:
            os.write(terminal, b"\t")
            turn += PAGE
        if not select.select([terminal], [], [], 0.1)[0]:
            continue
        try:
            shown += os.read(terminal, 65536).decode(errors="replace")
        except OSError:
            break
        # Between two characters of a text the terminal may be told where to write.
        is_found = text in re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]", "", shown)
    os.kill(child, signal.SIGINT)
    os.waitpid(child, 0)
    if not is_found:
        sys.exit(f"{command} did not show {text!r}, but:\n{shown!r}")
    print(text)


main()
