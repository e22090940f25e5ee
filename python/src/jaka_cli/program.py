"""Place of the program `jaka` that this distribution has installed."""

import importlib.metadata
import pathlib
import sys


def program_path() -> pathlib.Path:
    """Path of the program. Raises FileNotFoundError if it is missing, also where PATH has another `jaka`."""
    for file in importlib.metadata.files("jaka-cli") or []:
        program = pathlib.Path(file.locate()).resolve()
        # Python 3.12 and later leave missing files out of the list.
        if file.name in ("jaka", "jaka.exe") and program.is_file():
            return program
    raise FileNotFoundError(
        f"the program jaka is missing in the installation of jaka-cli in {sys.prefix}; install its wheel again"
    )
