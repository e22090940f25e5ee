"""The wheel as its users have it: run by `release/wheel` in an environment that has the wheel and pytest."""

import importlib.metadata
import json
import os
import socket
import subprocess
import sys

import pytest
from jaka_cli import Simulator, program_path

pytest_plugins = ["pytester"]


def call(simulator, command):
    """Reply to a command. The controller closes the connection after the last reply, since nothing more is sent."""
    with socket.create_connection(simulator.commands, timeout=60) as connection:
        connection.sendall(json.dumps({"cmdName": command}).encode())
        connection.shutdown(socket.SHUT_WR)
        return json.load(connection.makefile(encoding="utf-8"))


def power(simulator):
    return call(simulator, "get_robot_state")["power"]


def test_the_program_has_the_version_of_the_wheel():
    ended = subprocess.run([program_path(), "--version"], capture_output=True, text=True, check=True)
    assert ended.stdout == f"jaka {importlib.metadata.version('jaka-cli')}\n"


def test_the_wheel_has_the_licences():
    licences = {file.name for file in importlib.metadata.files("jaka-cli") if "licenses" in file.parts}
    assert licences == {"LICENSE-MIT", "LICENSE-APACHE", "THIRD-PARTY-LICENSES"}


def test_the_fixture_gives_a_controller_that_answers(jaka_simulator):
    assert jaka_simulator.host == "127.0.0.1"
    assert power(jaka_simulator) == "powered_off"
    with socket.create_connection(jaka_simulator.status, timeout=60) as status:
        assert status.recv(1) == b"{"


@pytest.mark.jaka_simulator("--powered", "--model", "zu12")
def test_the_marker_gives_options(jaka_simulator):
    assert power(jaka_simulator) == "powered_on"


def test_two_simulators_are_two_robots(jaka_simulator):
    with Simulator("--powered") as other:
        ports = {jaka_simulator.command_port, jaka_simulator.status_port, other.command_port, other.status_port}
        assert len(ports) == 4
        assert (power(jaka_simulator), power(other)) == ("powered_off", "powered_on")


def test_another_address(jaka_simulator):
    with Simulator("--address", "::1") as other:
        assert other.host == "::1"
        assert power(other) == "powered_off"


def test_the_end_of_the_block_ends_the_process():
    with Simulator() as simulator:
        connection = socket.create_connection(simulator.status, timeout=60)
        assert simulator.process.poll() is None
    assert simulator.process.returncode is not None
    with connection, pytest.raises((ConnectionResetError, EOFError)):
        while connection.recv(65536):
            pass
        raise EOFError


def test_a_failed_test_ends_the_process(pytester):
    pytester.makepyfile(
        """
        def test_fails(jaka_simulator):
            print("process", jaka_simulator.process.pid, "is up")
            assert False
        """
    )
    result = pytester.runpytest_subprocess()
    result.assert_outcomes(failed=1)
    line = next(line for line in result.outlines if line.startswith("process "))
    with pytest.raises(ProcessLookupError):
        os.kill(int(line.split()[1]), 0)


@pytest.mark.parametrize("page", ["python/README.md", "docs/install.md"])
def test_the_test_of_a_page_passes(pytester, request, page):
    text = (request.config.rootpath.parent / page).read_text(encoding="utf-8")
    pytester.makepyfile(text.split("\n```python\n")[1].split("```\n")[0])
    pytester.runpytest_subprocess("--strict-markers").assert_outcomes(passed=1)


def test_a_wrong_option_is_in_the_error():
    with pytest.raises(RuntimeError, match="the simulator did not start, exit code 2: .*--no-such-option"):
        Simulator("--no-such-option")


@pytest.mark.jaka_simulator("--log")
@pytest.mark.parametrize("options", ["powered=True", "['--powered']", "'--period', 50"])
def test_options_that_are_no_strings_are_refused(pytester, options):
    pytester.makepyfile(f"""
        import pytest

        @pytest.mark.jaka_simulator({options})
        def test_robot(jaka_simulator): pass
    """)
    result = pytester.runpytest_inprocess("-p", "no:cacheprovider")
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(["the marker jaka_simulator takes the options of `jaka sim` as separate strings, *"])


def test_a_simulator_that_does_not_start_is_one_line_of_a_report(pytester):
    pytester.makepyfile("""
        import pytest

        @pytest.mark.jaka_simulator("--power")
        def test_robot(jaka_simulator): pass
    """)
    result = pytester.runpytest_inprocess("-p", "no:cacheprovider")
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(["the simulator did not start, exit code 2: *--power*"])
    result.stdout.no_fnmatch_line("*subprocess*")


def test_a_log_that_nobody_reads_does_not_hold_the_simulator_up(jaka_simulator):
    # Requests whose log is more than a pipe holds.
    count = 2000
    with socket.create_connection(jaka_simulator.commands, timeout=60) as connection:
        connection.sendall(b'{"cmdName": "get_joint_pos"}' * count)
        connection.shutdown(socket.SHUT_WR)
        replies = connection.makefile(encoding="utf-8").read()
    assert replies.count('"get_joint_pos"') == count


def test_a_missing_program_is_named(pytester):
    pytester.makepyfile("def test_robot(jaka_simulator): pass")
    program = program_path()
    away = program.with_name("jaka-away")
    program.rename(away)
    try:
        result = pytester.runpytest_subprocess()
    finally:
        away.rename(program)
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(
        [f"*FileNotFoundError: the program jaka is missing in the installation of jaka-cli in {sys.prefix}; *"]
    )
