"""The program, as the command `tricontact` of a wheel."""

import os
import sys
from pathlib import Path


def main() -> None:
    """Runs the program beside this file in the place of this process."""
    program = Path(__file__).with_name("tricontact")
    if not program.is_file():
        sys.exit(f"tricontact: there is no program {program}; reinstall the wheel")
    os.execv(program, [str(program), *sys.argv[1:]])
