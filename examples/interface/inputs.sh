#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# What each input is worth (docs/inputs.md): K/A0 and its band at 30 MPa, of a scene that gets one more key in each line.
set -eu
scene='contact.pressures = ["30 MPa"]'
echo "one more key                      K/A0 [MPa/µm]  90 % band"
for key in 'Ra = "0.8 um"' 'process = "ground"' 'material.upper.name = "C45"' 'Sdq = 0.17' 'material.upper.hardness = "250 HV"' \
           'skewness = -0.2, kurtosis = 3.1'; do
    case $key in
        material*) lines=$key ;;
        *) lines=$(echo "surface.$key" | sed 's/, /\nsurface./') ;;
    esac
    scene="$scene
$lines"
    echo "$scene" | fstiff run - 2>/dev/null | awk -v key="$key" 'NR == 3 { printf "%-34s %12s  %s\n", key, $3, $4 }'
done
