#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One script that holds the program, its worker and the names of materials, so that a page from a disk needs to fetch nothing.

    bundle.py bin/fstiff bin/fstiff_materials.js web/engine.js     reads fstiff.js and fstiff.wasm, and worker.js of this folder
"""
import base64
import gzip
import json
import pathlib
import subprocess
import sys

program, materials, output = map(pathlib.Path, sys.argv[1:])
script = program.with_suffix(".js").read_text(encoding="utf-8") + (
    pathlib.Path(__file__).parent / "worker.js").read_text(encoding="utf-8")
packed = gzip.compress(program.with_suffix(".wasm").read_bytes(), mtime=0)
names = subprocess.run(["node", materials], capture_output=True, text=True, check=True).stdout.split()
texts = {"script": script, "wasm": base64.b64encode(packed).decode(), "materials": names}
output.write_text(f"var fstiff_engine = {json.dumps(texts)};\n", encoding="utf-8")
