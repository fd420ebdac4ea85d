#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A sweep where mpirun starts processes: mpi.sh GRID [options of mpirun, such as -n 4]. They do not talk to each other, so
# that no MPI is linked; rank and size come from the environment.
fstiff=${FSTIFF:-fstiff}
grid=$1
shift
mpirun "$@" "$fstiff" sweep "$grid" --shard auto --threads 1 -o "part-{shard}.jsonl" &&
    cat part-*.jsonl >all.jsonl
