"""The pytest fixture `jaka_simulator`."""

import pytest

from jaka_cli.simulator import Simulator


def pytest_configure(config):
    config.addinivalue_line("markers", "jaka_simulator(*options): options of `jaka sim` for the fixture jaka_simulator")


@pytest.fixture
def jaka_simulator(request):
    """A simulated controller for this test, with the options of its marker: see `jaka_cli.Simulator`."""
    marker = request.node.get_closest_marker("jaka_simulator")
    options = marker.args if marker else ()
    if marker and (marker.kwargs or not all(isinstance(option, str) for option in options)):
        pytest.fail(
            "the marker jaka_simulator takes the options of `jaka sim` as separate strings, "
            'such as @pytest.mark.jaka_simulator("--powered", "--model", "zu5")',
            pytrace=False,
        )
    try:
        simulator = Simulator(*options)
    except RuntimeError as error:
        pytest.fail(str(error), pytrace=False)
    with simulator:
        yield simulator
