#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One script that holds the program and its worker, so that a page from a disk needs to fetch nothing.

    bundle.py build/web/bin/fstiff web/engine.js        reads fstiff.js and fstiff.wasm, and worker.js of this folder
"""
import base64
import gzip
import json
import pathlib
import sys

program, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
script = program.with_suffix(".js").read_text(encoding="utf-8") + (
    pathlib.Path(__file__).parent / "worker.js").read_text(encoding="utf-8")
packed = gzip.compress(program.with_suffix(".wasm").read_bytes(), mtime=0)
texts = {"script": script, "wasm": base64.b64encode(packed).decode()}
output.write_text(f"var fstiff_engine = {json.dumps(texts)};\n", encoding="utf-8")
