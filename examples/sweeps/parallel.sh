#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A sweep by GNU parallel on one machine, or on several with its --sshlogin: parallel.sh GRID [CHUNKS]
# The same command again computes the chunks that sweep.log does not have as done; a new sweep begins in an empty folder.
set -e
FSTIFF=${FSTIFF:-fstiff}
grid=$1
chunks=${2:-8}
export FSTIFF grid

scenes=$("$FSTIFF" sweep "$grid" --count)
for i in $(seq "$chunks"); do
    printf '%08d %d:%d\n' "$i" $((scenes * (i - 1) / chunks)) $((scenes * i / chunks))
done >chunks.txt

# exit code 4: a scene has no result, and its line has the reason
parallel --colsep ' ' --joblog sweep.log --resume-failed --retries 3 \
    '"$FSTIFF" sweep "$grid" --rows {2} --threads 1 -o part-{1}.jsonl || [ $? -eq 4 ]' <chunks.txt
cut -d' ' -f1 chunks.txt | sed 's/.*/part-&.jsonl/' | xargs cat >all.jsonl
