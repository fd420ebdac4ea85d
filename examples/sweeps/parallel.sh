#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A sweep by GNU parallel on one machine, or on several with its --sshlogin: parallel.sh GRID
fstiff=${FSTIFF:-fstiff}
seq 8 | parallel "$fstiff" sweep "$1" --shard {}/8 --threads 1 -o part-{shard}.jsonl &&
    cat part-*.jsonl >all.jsonl
