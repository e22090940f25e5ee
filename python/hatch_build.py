"""Puts the binary into the wheel, and names its platform: `release/wheel` sets both."""

import os

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class Binary(BuildHookInterface):
    def initialize(self, version, build_data):
        binary = os.environ["JAKA_BINARY"]
        build_data["shared_scripts"] = {binary: os.path.basename(binary)}
        build_data["tag"] = f"py3-none-{os.environ['JAKA_PLATFORM']}"
        build_data["pure_python"] = False
