#!/bin/sh
# How the cost of a scene grows with its reflections: a line for each depth, one run each.
#
# Usage: depths.sh SCENE [DEPTH...]
# The program is $CATOPTRIC, or catoptric on the PATH. Needs python3 to read the statistics.
set -eu
catoptric=${CATOPTRIC:-catoptric}
scene=${1:?usage: depths.sh SCENE [DEPTH...]}
shift
[ $# -gt 0 ] || set -- 0 1 2 4 8 16 32

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

printf '%10s %12s %10s\n' depth rays 'trace ms'
for depth in "$@"; do
    "$catoptric" render "$scene" --max-depth "$depth" --quiet \
        -o "$work/picture.pfm" --stats "$work/stats.json"
    python3 - "$work/stats.json" <<'PYTHON'
import json, sys

stats = json.load(open(sys.argv[1]))
rays = sum(stats["rays"].values())
print(f"{stats['max_depth']:10} {rays:12} {stats['time_ms']['trace']:10.2f}")
PYTHON
done
