#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Loss factor of a bolted joint against the amplitude of its vibration: damping.sh [SCAN], a profile or map of one face.
# Without a scan it generates one.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
if [ $# -gt 0 ]; then
    cp -- "$1" "$work/scan.txt"
else
    fstiff generate map --points 128 --spacing "2 um" --longest "60 um" --rms "0.8 um" --hurst 0.8 --seed 7 -o "$work/scan.txt"
fi
cp "$here/damping.toml" "$work"
fstiff sweep "$work/damping.toml" -o "$work/damping.jsonl" >/dev/null 2>&1
echo "amplitude [um]  loss factor  5 %     95 %"
python3 - "$work/damping.jsonl" <<'EOF'
import json, sys
for line in open(sys.argv[1]):
    row = json.loads(line)
    print(f'{row["friction.amplitude"] * 1e6:<14.3f}  {row["loss_factor"]:<11.3f}', end='  ')
    print(f'{row["loss_factor_p05"]:.3f}   {row["loss_factor_p95"]:.3f}')
EOF
