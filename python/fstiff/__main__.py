# SPDX-License-Identifier: BSD-3-Clause
"""python -m fstiff: pages and pictures of what the command `fstiff` computes."""

from __future__ import annotations

import argparse
import sys

from . import _report, _run
from ._core import version

#: The commands: a module has add_arguments(parser) and execute(arguments), which returns the exit code.
COMMANDS = {"run": _run, "report": _report}


def main(words: list[str] | None = None) -> int:
    """Runs the command of `words`. Returns its exit code, that of `fstiff`: 0 done, 2 usage, 3 bad input or data, 4 doubtful."""
    parser = argparse.ArgumentParser(prog="python -m fstiff", description=__doc__)
    parser.add_argument("--version", action="version", version=f"fstiff {version}")
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    for name, module in COMMANDS.items():
        first_line = (module.__doc__ or "").partition("\n")[0]
        command = commands.add_parser(name, help=first_line, description=module.__doc__)
        module.add_arguments(command)
        command.set_defaults(execute=module.execute)
    arguments = parser.parse_args(words)
    try:
        return int(arguments.execute(arguments))
    except (ValueError, OSError, ImportError) as error:
        print(f"fstiff: {error}", file=sys.stderr)
        return 3


if __name__ == "__main__":
    sys.exit(main())
