"""The program `jaka` of this Python environment, and a simulated controller for tests."""

from jaka_cli.program import program_path
from jaka_cli.simulator import Simulator

__all__ = ["Simulator", "program_path"]
