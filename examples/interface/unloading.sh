#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# K of unloading against pressure, in place of an ultrasonic test: boundary elements of a map under the hardness of unloading.toml.
# The errors are 10 %. The first line has what a fit should find.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
map() {
    fstiff generate map --points 256 --spacing "0.5 um" --hurst 0.8 --rms "0.8 um" --longest "16 um" --shortest "3 um" --seed 1
}
map | fstiff measure - --format table 2>/dev/null |
    awk '$1 == "rms_height" { height = $2 } $1 == "rms_gradient" { print "# of a map with sigma", height, "um, g", $2 }'
echo "pressure [MPa],stiffness [MPa/um],error [MPa/um]"
map | fstiff run "$here/unloading.toml" --surface - --format csv 2>/dev/null |
    awk -F, 'NR > 1 { printf "%g,%.0f,%.0f\n", $4 / 1e6, $7 / 1e12, $7 / 1e13 }'
