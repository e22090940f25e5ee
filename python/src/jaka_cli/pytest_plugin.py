"""The pytest fixture `jaka_simulator`."""

import pytest

from jaka_cli.simulator import Simulator


def pytest_configure(config):
    config.addinivalue_line("markers", "jaka_simulator(*options): options of `jaka sim` for the fixture jaka_simulator")


@pytest.fixture
def jaka_simulator(request):
    """A simulated controller for this test, with the options of its marker: see `jaka_cli.Simulator`."""
    marker = request.node.get_closest_marker("jaka_simulator")
    with Simulator(*(marker.args if marker else ())) as simulator:
        yield simulator
