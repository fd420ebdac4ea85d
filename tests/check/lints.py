#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs those checks of tools/lint.py that need no build, as the hook of a commit does."""

import pathlib
import subprocess
import sys

LINT = pathlib.Path(__file__).resolve().parents[2] / "tools/lint.py"
failed = [check for check in ("layers", "glossary", "api", "sizes", "words") if subprocess.run([sys.executable, LINT, check]).returncode != 0]
sys.exit(f"lint.py refuses: {', '.join(failed)}" if failed else 0)
