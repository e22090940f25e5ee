"""Place of the program `jaka` that this distribution has installed."""

import importlib.metadata
import pathlib


def program_path() -> pathlib.Path:
    """Path of the program. Raises FileNotFoundError if it is missing, also where PATH has another `jaka`."""
    for file in importlib.metadata.files("jaka-cli") or []:
        if file.name in ("jaka", "jaka.exe"):
            program = pathlib.Path(file.locate()).resolve()
            if program.is_file():
                return program
            raise FileNotFoundError(f"the program jaka is missing at {program}; install the wheel jaka-cli again")
    raise FileNotFoundError("this installation of jaka-cli has no program jaka; install it from a wheel")
